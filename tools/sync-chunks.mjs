import { runTool } from './run.mjs';

await runTool('sync-chunks/main.ts');
