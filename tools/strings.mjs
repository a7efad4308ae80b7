import { runTool } from './run.mjs';

await runTool('strings/main.ts');
