import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Command } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';
import { nameNodes } from '../name-nodes.ts';
import { askDriver, type DriverAnswer, NO_DRIVER_OPTION } from '../shader/ask-driver.ts';

/** The answer for a project that does not compile, which the graphics driver does not check. */
const UNASKED: DriverAnswer = { driver: 'not-needed', diagnostics: [] };

export const checkCommand: Command = {
  name: 'check',
  usage: 'PROJECT',
  summary: 'Check a project for problems',
  doc: 'Compiles PROJECT, checks its assets and prints each problem: file, line and column where known, the title and id of the node, what is wrong and what to do. Also compiles the project’s own shaders with a graphics driver, in a headless browser; without a browser it prints a warning instead. Only errors give status 1.',
  project: 'required',
  options: { 'no-driver': NO_DRIVER_OPTION },
  examples: [
    { line: 'scrim check my-project', says: 'Prints each problem on its own line.' },
    {
      line: 'scrim check my-project --json',
      says: 'For other programs: { ok, driver, diagnostics: [{ code, severity, message, nodeId, file, line, … }] }; driver is yes, not-needed, not-wanted or no-browser.',
    },
  ],
  run: async (call, context) => {
    const { say, paint } = context;
    say('Compiling…');
    const compiled = await compileFolder(call.project, () => ({ reportUnused: true }));
    const wanted = !call.flag('no-driver');
    const asked = compiled.program === null ? UNASKED : await askDriver({ ...context, ...compiled, wanted });
    const diagnostics = [...compiled.diagnostics, ...asked.diagnostics];
    const ok = !hasErrors(diagnostics);
    const lines = nameNodes(compiled.files, diagnostics).map(paint.diagnostic);
    return {
      status: ok ? 0 : 1,
      json: { ok, driver: asked.driver, diagnostics },
      text: lines.length === 0 ? 'No problems found.' : lines.join('\n'),
      diagnostics: [],
    };
  },
};
