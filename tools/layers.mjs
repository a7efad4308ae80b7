import { runTool } from './run.mjs';

await runTool('layers/main.ts');
