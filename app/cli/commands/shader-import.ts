import { readFile } from 'node:fs/promises';
import { basename, extname } from 'node:path';
import { convertShadertoy, isShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import { makeShaderFile } from '../../../export/graph/names.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { type Command, failed, UsageError } from '../command.ts';

export const shaderImportCommand: Command = {
  name: 'shader import',
  usage: 'FILE [--out FILE.fs]',
  summary: 'Make an ISF file of a Shadertoy source',
  doc: 'Reads a work of shadertoy.com: the code of its tabs, with a line such as “// Buffer A” before each where there are several, or the site’s JSON. Buffers become passes, pictures become layers, the pointer becomes a point. Credit and licence come from the source; where it names no licence, the site’s own, CC BY-NC-SA 3.0, is written down. Nothing is overwritten.',
  project: 'required',
  operand: { word: 'FILE', doc: 'the source, as text or JSON' },
  options: { out: { type: 'string', value: 'FILE.fs', doc: 'Where the ISF file goes; by default here, under the work’s name.' } },
  examples: [
    { line: 'scrim shader import ripples.glsl', says: 'Writes ripples.fs, and says whose work it is and under which terms.' },
    { line: 'scrim shader import export.json --out my-project/shaders/ripples.fs', says: 'Puts it into a project, as a node type.' },
  ],
  run: async (call) => {
    const path = call.project;
    const source = await readFile(path, 'utf8').catch(() => {
      throw new UsageError(`There is no file ${path} to read.`);
    });
    if (!isShadertoy(source)) {
      const message = 'This is no source of shadertoy.com: it has neither a function mainImage nor "renderpass" as the site’s JSON has.';
      return failed([{ code: 'SCR045', severity: 'error', file: path, message }]);
    }
    const { output, diagnostics } = convertShadertoy(source, path);
    if (output === null) return failed(diagnostics);
    const { text, title, credit, licence } = output;
    const out = call.text('out') || makeShaderFile(title || basename(path, extname(path)));
    try {
      await NODE_FILES.writeNew(out, new TextEncoder().encode(text));
    } catch (error) {
      const taken = (error as NodeJS.ErrnoException).code === 'EEXIST';
      const message = taken ? `There is a file ${out} already.` : `${out} cannot be written: ${(error as Error).message}.`;
      const fix = taken ? 'Name another with --out.' : 'Name another place with --out.';
      return failed([{ code: taken ? 'SCR061' : 'SCR060', severity: 'error', file: out, message, fix }]);
    }
    return {
      status: 0,
      json: { ok: true, out, title, credit, licence, diagnostics },
      text: `Made ${out}.\nCredit: ${credit}\nLicence: ${licence}`,
      diagnostics,
    };
  },
};
