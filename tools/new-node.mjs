import { runTool } from './run.mjs';

await runTool('new-node/main.ts');
