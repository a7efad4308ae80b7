import { runTool } from './run.mjs';

await runTool('test/main.ts');
