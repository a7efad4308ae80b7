import { countRounds } from '../../../export/glsl/check/count-rounds.ts';
import { checkIsf } from '../../../export/glsl/isf/checked-isf.ts';
import type { IsfShader } from '../../../export/glsl/isf/isf-shader.ts';
import { readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../../export/glsl/link/link-isf.ts';
import type { LinkedPass } from '../../../export/glsl/link/linked-pass.ts';
import { GlslError } from '../../../export/glsl/syntax/token.ts';
import { linkTechnique } from '../../../export/glsl/technique/link-technique.ts';
import { readTechnique } from '../../../export/glsl/technique/read-technique.ts';
import { isTechniqueFile } from '../../../export/glsl/technique/technique-shader.ts';
import { LOOP_BUDGET } from '../../../export/program/loop-budget.ts';
import type { LinkedShader } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import type { ShaderJob } from './driver.page.ts';

export interface LinkedFile {
  readonly file: string;
  readonly source: string;
  /** One for each pass, with what the driver has to be given to draw it. */
  readonly passes: readonly { readonly shader: LinkedShader; readonly job: ShaderJob }[];
  /** What can be said without a driver; with an error among it there are no passes. */
  readonly diagnostics: readonly Diagnostic[];
}

/** A file as a new node would have it: all inputs wired, and with their first values. By its ending it is a technique, else ISF. */
export function linkFile(source: string, file: string): LinkedFile {
  return isTechniqueFile(file) ? linkTechniqueFile(source, file) : linkIsfFile(source, file);
}

function linkIsfFile(source: string, file: string): LinkedFile {
  const read = readIsf(source, file);
  if (read.output === null) return { file, source, passes: [], diagnostics: read.diagnostics };
  const shader = read.output;
  const linked = linkIsf(shader, { node: '', loopBudget: !endsInTime(shader) });
  return {
    file,
    source,
    passes: (linked.output ?? []).map((pass) => ({ shader: pass.shader, job: jobOf(pass, shader) })),
    diagnostics: [...read.diagnostics, ...linked.diagnostics],
  };
}

/** Running a shader costs more than all else: those whose loops can be counted are only compiled. */
function endsInTime(shader: IsfShader): boolean {
  try {
    return countRounds(checkIsf(shader).checked) <= LOOP_BUDGET;
  } catch (fault) {
    if (!(fault instanceof GlslError)) throw fault;
    // The link says what it is.
    return true;
  }
}

function linkTechniqueFile(source: string, file: string): LinkedFile {
  const read = readTechnique(source, file);
  const options = { chunkOf: (name: string) => LIBRARY.shader(`chunks/${name}.glsl`), loopBudget: true };
  const linked = read.output && linkTechnique(read.output, options);
  const trial = linked?.output?.trial;
  const samplers = (linked?.output?.samplers ?? []).map(({ name }) => ({ name, isDepth: false }));
  return {
    file,
    source,
    passes: trial ? [{ shader: trial, job: { shader: trial, passIndex: 0, uniforms: [], samplers } }] : [],
    diagnostics: [...read.diagnostics, ...(linked?.diagnostics ?? [])],
  };
}

function jobOf({ shader, passIndex, uniforms, samplers }: LinkedPass, { inputs }: IsfShader): ShaderJob {
  return {
    shader: { id: shader.id, vertex: shader.vertex, fragment: shader.fragment },
    passIndex,
    uniforms: uniforms.map(({ name, type, source }) => ({
      name,
      type,
      value: 'builtin' in source ? source.builtin : (inputs.find((input) => input.name === source.param)?.default ?? []),
    })),
    samplers: samplers.map(({ name, source }) => ({ name, isDepth: source.kind === 'input-depth' || source.kind === 'room-depth' })),
  };
}
