import { runTool } from './run.mjs';

await runTool('sessions/convert-session.ts');
