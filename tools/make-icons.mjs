import { runTool } from './run.mjs';

await runTool('icons/main.ts');
