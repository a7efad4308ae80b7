import { runTool } from './run.mjs';

await runTool('gen/main.ts');
