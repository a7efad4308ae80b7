import { describeProgram } from '../../../export/compiler/describe.ts';
import { type Command, failed } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';

export const planCommand: Command = {
  name: 'plan',
  usage: 'PROJECT',
  summary: 'Show the compiled program',
  doc: 'Compiles PROJECT and prints the program: its operations per frame and per view in order, its textures and their sizes, the features that it requests, and what each kind of device can show.',
  project: 'required',
  options: {},
  examples: [
    { line: 'scrim plan examples/first-light', says: 'Prints the program as text.' },
    {
      line: 'scrim plan examples/first-light --json > program.json',
      says: 'The program itself, shaders included: { ok, program, diagnostics }.',
    },
  ],
  run: async (call) => {
    const { files, program, diagnostics } = await compileFolder(call.project);
    if (program === null) return failed(diagnostics, files);
    return { status: 0, json: { ok: true, program, diagnostics }, text: describeProgram(program).trimEnd(), diagnostics, files };
  },
};
