import { runTool } from './run.mjs';

await runTool('bench/main.ts');
