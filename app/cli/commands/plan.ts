import { describeProgram } from '../../../export/compiler/describe.ts';
import { type Command, failed } from '../command.ts';
import { compileFolder } from '../compile-folder.ts';

export const planCommand: Command = {
  name: 'plan',
  usage: 'PROJECT',
  summary: 'Show what a project is compiled to',
  doc: 'Compiles PROJECT and tells the program: what is done per frame and per view, in which order, which textures that takes and how large they are, what a visitor’s device is asked for, and what each kind of device can show.',
  project: 'required',
  options: {},
  examples: [
    { line: 'scrim plan examples/first-light', says: 'The program in words.' },
    {
      line: 'scrim plan examples/first-light --json > program.json',
      says: 'The program itself, shaders included: { ok, program, diagnostics }.',
    },
  ],
  run: async (call) => {
    const { program, diagnostics } = await compileFolder(call.project);
    if (program === null) return failed(diagnostics);
    return { status: 0, json: { ok: true, program, diagnostics }, text: describeProgram(program).trimEnd(), diagnostics };
  },
};
