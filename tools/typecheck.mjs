import { runTool } from './run.mjs';

await runTool('typecheck/main.ts');
