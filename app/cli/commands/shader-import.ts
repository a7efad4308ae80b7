import { readFile } from 'node:fs/promises';
import { basename, extname } from 'node:path';
import { convertShadertoy, isShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import { makeShaderFile } from '../../../export/graph/document-names.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { type Command, failed, UsageError } from '../command.ts';

export const shaderImportCommand: Command = {
  name: 'shader import',
  usage: 'FILE [--out FILE.fs]',
  summary: 'Convert a Shadertoy shader to ISF',
  doc: 'Reads a shader of shadertoy.com: the code of its tabs, with a line such as “// Buffer A” before each if there are several, or the site’s JSON. Buffers become passes, images become layers, the mouse becomes a point. Credit and license come from the source; without a license in it, the site’s default, CC BY-NC-SA 3.0, is written. Never overwrites a file.',
  project: 'required',
  operand: { word: 'FILE', doc: 'the source, as text or JSON' },
  options: { out: { type: 'string', value: 'FILE.fs', doc: 'The ISF file to write; by default in this folder, named after the shader.' } },
  examples: [
    { line: 'scrim shader import ripples.glsl', says: 'Writes ripples.fs and prints its credit and license.' },
    { line: 'scrim shader import export.json --out my-project/shaders/ripples.fs', says: 'Adds it to a project as a node type.' },
  ],
  run: async (call) => {
    const path = call.project;
    const source = await readFile(path, 'utf8').catch(() => {
      throw new UsageError(`${path} cannot be read.`);
    });
    if (!isShadertoy(source)) {
      const message = 'This is not a Shadertoy source: it has neither a function mainImage nor the "renderpass" of the site’s JSON.';
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
      const message = taken ? `${out} already exists.` : `${out} cannot be written: ${(error as Error).message}.`;
      const fix = taken ? 'Name another file with --out.' : 'Name another place with --out.';
      return failed([{ code: taken ? 'SCR061' : 'SCR060', severity: 'error', file: out, message, fix }]);
    }
    return {
      status: 0,
      json: { ok: true, out, title, credit, licence, diagnostics },
      text: `Made ${out}.\nCredit: ${credit}\nLicense: ${licence}`,
      diagnostics,
    };
  },
};
