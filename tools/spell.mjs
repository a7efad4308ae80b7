import { runTool } from './run.mjs';

await runTool('spell/main.ts');
