import { runTool } from './run.mjs';

await runTool('sessions/make-studio.ts');
