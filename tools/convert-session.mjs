import { runTool } from './run.mjs';

await runTool('sessions/convert-open3d.ts');
