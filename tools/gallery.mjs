import { runTool } from './run.mjs';

await runTool('gallery/main.ts');
