import { runTool } from './run.mjs';

await runTool('package/main.ts');
