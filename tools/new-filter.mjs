import { runTool } from './run.mjs';

await runTool('new-filter/main.ts');
