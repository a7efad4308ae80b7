import { runTool } from './run.mjs';

await runTool('docs/main.ts');
