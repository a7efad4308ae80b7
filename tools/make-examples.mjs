import { runTool } from './run.mjs';

await runTool('examples/main.ts');
