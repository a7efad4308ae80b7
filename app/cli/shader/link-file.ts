import { readFileSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { IsfShader } from '../../../export/glsl/isf/isf-shader.ts';
import { type Before, linkAbove } from '../../../export/glsl/link/link-above.ts';
import { linkIsf } from '../../../export/glsl/link/link-isf.ts';
import type { LinkedPass, LinkedSampler, LinkedUniform } from '../../../export/glsl/link/linked-pass.ts';
import { readImageShader } from '../../../export/glsl/read-definition.ts';
import { linkTechnique, linkTechniqueAbove } from '../../../export/glsl/technique/link-technique.ts';
import { readTechnique } from '../../../export/glsl/technique/read-technique.ts';
import { isTechnique } from '../../../export/glsl/technique/technique-shader.ts';
import type { LinkedShader } from '../../../export/program/program.ts';
import { SHADERS } from '../../../nodes/generated/definitions.gen.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { ShaderJob } from './driver.page.ts';

export interface LinkedFile {
  readonly file: string;
  readonly source: string;
  /** One entry per pass, with the inputs that the driver needs to draw it. */
  readonly passes: readonly { readonly shader: LinkedShader; readonly job: ShaderJob }[];
  /** Diagnostics of the parser and linker. After an error, `passes` contain only the text before it. */
  readonly diagnostics: readonly Diagnostic[];
  /** After an error: which driver messages apply to the text before it; else null. */
  readonly before: Before | null;
}

/**
 * Links a file as a new node would: all inputs connected, all params at their defaults. Name and content tell whether it is a
 * technique, a transition or another ISF file. `vertex` is the text of its vertex shader, if any.
 */
export function linkFile(source: string, file: string, vertex: string | null): LinkedFile {
  return isTechnique(source, file) ? linkTechniqueFile(source, file) : linkImageShader(source, file, vertex);
}

function linkImageShader(source: string, file: string, vertex: string | null): LinkedFile {
  const read = readImageShader(source, file, vertex);
  if (read.output === null) return { file, source, passes: [], diagnostics: read.diagnostics, before: null };
  const shader = read.output;
  const options = { node: '', loopBudget: true };
  const linked = linkIsf(shader, options);
  const [refused] = linked.diagnostics;
  const above = linked.output === null && refused !== undefined ? linkAbove(shader, options, refused) : null;
  return {
    file,
    source,
    passes: (linked.output ?? above?.output ?? []).map((pass) => ({ shader: pass.shader, job: jobOf(pass, shader) })),
    diagnostics: [...read.diagnostics, ...(above?.diagnostics ?? []), ...linked.diagnostics],
    before: above?.before ?? null,
  };
}

function linkTechniqueFile(source: string, file: string): LinkedFile {
  const read = readTechnique(source, file);
  const options = { chunkOf: (name: string) => chunkBeside(file, name) ?? SHADERS[`chunks/${name}.glsl`], loopBudget: true };
  if (read.output === null) return { file, source, passes: [], diagnostics: read.diagnostics, before: null };
  const linked = linkTechnique(read.output, options);
  const [refused] = linked.diagnostics;
  const above = linked.output === null && refused !== undefined ? linkTechniqueAbove(read.output, options, refused) : null;
  const { trial, samplers: layers = [] } = linked.output ?? above?.output ?? {};
  const samplers = layers.map(({ name }) => ({ name, holds: 'color' as const }));
  return {
    file,
    source,
    passes: trial ? [{ shader: trial, job: { shader: trial, passIndex: 0, uniforms: [], samplers } }] : [],
    diagnostics: [...read.diagnostics, ...(above?.diagnostics ?? []), ...linked.diagnostics],
    before: above?.before ?? null,
  };
}

/** Text of a chunk in the folder `chunks` beside a technique. It overrides that of the library, as in projects. */
export function chunkBeside(file: string, name: string): string | undefined {
  try {
    const chunk = join(dirname(file), 'chunks', `${name}.glsl`);
    // Opening a named pipe would block forever.
    return statSync(chunk).isFile() ? readFileSync(chunk, 'utf8') : undefined;
  } catch {
    return undefined;
  }
}

function jobOf({ shader, passIndex, uniforms, samplers }: LinkedPass, { inputs, imported }: IsfShader): ShaderJob {
  return {
    shader,
    passIndex,
    uniforms: uniforms.map(({ name, type, source }) => ({
      name,
      type,
      value: firstValue(source, inputs),
    })),
    samplers: samplers.map(({ name, source }) => ({ name, holds: contentOf(source, imported) })),
  };
}

function firstValue(source: LinkedUniform['source'], inputs: IsfShader['inputs']): ShaderJob['uniforms'][number]['value'] {
  if ('builtin' in source) return source.builtin;
  if ('event' in source) return [0];
  return inputs.find((input) => input.name === source.param)?.default ?? [];
}

function contentOf(source: LinkedSampler['source'], imported: IsfShader['imported']): ShaderJob['samplers'][number]['holds'] {
  if (source.kind === 'input' || source.kind === 'buffer') return 'color';
  if (source.kind !== 'import') return 'number';
  return imported.find(({ name }) => name === source.import)?.cube ? 'cube' : 'color';
}
