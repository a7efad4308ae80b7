import { describeFolded, describeProgram, describeSeparate } from '../../../export/compiler/describe.ts';
import { type Command, failed } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';

export const planCommand: Command = {
  name: 'plan',
  usage: 'PROJECT',
  summary: 'Show the compiled program',
  doc: 'Compiles PROJECT and prints the program: its operations per frame and per view in order, its textures and their sizes, the features that it requests, and what each kind of device can show. Passes that one shader draws are fused, and nodes without effect are left out, each with the reason, as in an exported page.',
  project: 'required',
  options: {
    why: { type: 'boolean', doc: 'Also print which layers are drawn to textures although only passes read them, each with the reason.' },
  },
  examples: [
    { line: 'scrim plan examples/first-light', says: 'Prints the program as text.' },
    { line: 'scrim plan examples/swirl --why', says: 'Also tells why passes are not fused.' },
    {
      line: 'scrim plan examples/first-light --json > program.json',
      says: 'The program itself, shaders included: { ok, program, separate, folded, diagnostics }.',
    },
  ],
  run: async (call) => {
    const { files, program, separate, folded, diagnostics } = await compileFolder(call.project, () => ({ fuse: true, fold: true }));
    if (program === null) return failed(diagnostics, files);
    const parts = [describeProgram(program), describeFolded(folded), ...(call.flag('why') ? [describeSeparate(separate)] : [])];
    const text = parts.filter((part) => part !== '').join('\n');
    return { status: 0, json: { ok: true, program, separate, folded, diagnostics }, text: text.trimEnd(), diagnostics, files };
  },
};
