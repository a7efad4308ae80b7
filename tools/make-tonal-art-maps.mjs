import { runTool } from './run.mjs';

await runTool('tonal-art-maps/main.ts');
