import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Command } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';

export const checkCommand: Command = {
  name: 'check',
  usage: 'PROJECT',
  summary: 'Say what is wrong with a project',
  doc: 'Reads PROJECT, compiles it and looks at its assets, and prints what is wrong: file, line and column where they are known, the node, what it is and what to do. Warnings are printed too; only errors give status 1.',
  project: 'required',
  options: {},
  examples: [
    { line: 'scrim check my-project', says: 'Prints one line per problem, or that there is none.' },
    {
      line: 'scrim check my-project --json',
      says: 'For other programs: { ok, diagnostics: [{ code, severity, message, nodeId, file, line, … }] }.',
    },
  ],
  run: async (call, { say, paint }) => {
    say('Compiling…');
    const { diagnostics } = await compileFolder(call.project, () => ({ reportUnused: true }));
    const ok = !hasErrors(diagnostics);
    const lines = diagnostics.map(paint.diagnostic);
    return {
      status: ok ? 0 : 1,
      json: { ok, diagnostics },
      text: lines.length === 0 ? 'Nothing is wrong.' : lines.join('\n'),
      diagnostics: [],
    };
  },
};
