import { runTool } from './run.mjs';

await runTool('newcomer/main.ts');
