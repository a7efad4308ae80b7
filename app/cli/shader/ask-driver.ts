import { uniqueDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import type { PassOperation, PassSampler, Program } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../../contract/contract.ts';
import { HostError } from '../../contract/host-error.ts';
import { findChromium } from '../../services/chromium.ts';
import { compileProject, LIBRARY } from '../../services/compile-project.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import type { Context, Option } from '../command.ts';
import type { ShaderJob, ShaderVerdict } from './driver.page.ts';
import { verdictDiagnostics, withDriver } from './with-driver.ts';

/**
 * Whether a graphics driver compiled the shaders of the project. `not-needed`: the project has no shaders of its own, and those of
 * Scrim are compiled by its tests. `not-wanted`: an option skipped it. `no-browser`: there is no browser with a driver.
 */
export type DriverAsked = 'yes' | 'not-needed' | 'not-wanted' | 'no-browser';

export interface DriverAnswer {
  readonly driver: DriverAsked;
  readonly diagnostics: readonly Diagnostic[];
}

export const NO_DRIVER_OPTION: Option = {
  type: 'boolean',
  doc: 'Do not compile the project’s own shaders with a graphics driver.',
};

export interface DriverQuestion extends Pick<Context, 'installation' | 'say' | 'interrupted'> {
  /** Real path of the project folder. */
  readonly root: string;
  readonly files: ProjectFiles;
  readonly wanted: boolean;
}

/** Compiles the shaders of a compiled program with a graphics driver, and runs their loops. */
export async function askDriver({ root, files, wanted, installation, say, interrupted }: DriverQuestion): Promise<DriverAnswer> {
  if (!wanted) return { driver: 'not-wanted', diagnostics: [] };
  if (Object.keys(files.sources).length === 0) return { driver: 'not-needed', diagnostics: [] };
  const { program } = await compileProject(root, files, () => ({ loopBudget: true, sourceMaps: true }));
  if (program === null || program.shaders.length === 0) return { driver: 'not-needed', diagnostics: [] };
  const jobs = program.shaders.map((_, index) => jobOf(program, index));
  const chromium = await findChromium();
  if (chromium === null) return noDriver('No browser was found');
  let verdicts: readonly ShaderVerdict[];
  try {
    verdicts = await withDriver({ root: installation.root, chromium, say }, (judge) => {
      interrupted.throwIfAborted();
      say('Compiling the shaders…');
      return judge(jobs);
    });
  } catch (error) {
    if (error instanceof HostError && error.diagnostic.code === 'SCR071') return noDriver(error.message.replace(/\.$/, ''));
    throw error;
  }
  const sourceOf = (file: string) => files.sources[file.replace(/^shaders\//, '')] ?? LIBRARY.shader(file);
  const said = program.shaders.flatMap((shader, i) => verdictDiagnostics(shader, verdicts[i], sourceOf));
  return { driver: 'yes', diagnostics: uniqueDiagnostics(said) };
}

function noDriver(why: string): DriverAnswer {
  const message = `${why}. The project’s own shaders were not checked by a graphics driver.`;
  return { driver: 'no-browser', diagnostics: [{ ...NO_BROWSER, severity: 'warning', message }] };
}

/** The shader with the initial values of the first pass that draws it. A technique is compiled alone and needs none. */
function jobOf({ shaders, operations, slots }: Program, index: number): ShaderJob {
  const shader = shaders[index];
  if (!shader) throw new Error(`The program has no shader ${index}.`);
  const pass = operations.find((operation): operation is PassOperation => operation.kind === 'pass' && operation.shader === index);
  const numbersOf = (slot: number) => {
    const { offset = 0 } = slots.slots[slot] ?? {};
    return slots.numbers.slice(offset, offset + 4);
  };
  return {
    shader,
    passIndex: pass?.passIndex ?? 0,
    uniforms: (pass?.uniforms ?? []).map(({ name, type, source }) => ({
      name,
      type,
      value: 'builtin' in source ? source.builtin : 'slot' in source ? numbersOf(source.slot) : [0],
    })),
    samplers: (pass?.samplers ?? []).map(({ name, source }) => ({ name, holds: contentOf(source) })),
  };
}

function contentOf(source: PassSampler['source']): ShaderJob['samplers'][number]['holds'] {
  if (source.kind === 'import') return source.cube ? 'cube' : 'color';
  return source.kind === 'color' ? 'color' : 'number';
}
