import type { Program } from '../program/program.ts';
import type { Engine } from './engine.ts';
import type { GlProgram, ShaderError } from './gl/program-cache.ts';

/** What a program needs before its first frame: linked GL programs, in the order of its shaders, and its assets. */
export interface LoadedProgram {
  readonly program: Program;
  readonly glPrograms: readonly GlProgram[];
  readonly errors: readonly ShaderError[];
  /** Resolves when each asset has its final form or failed; never rejects. */
  readonly complete: Promise<void>;
  release(): void;
}

export interface Loading {
  /** Resolves to the loaded program, or to null if loading was canceled. */
  readonly done: Promise<LoadedProgram | null>;
  cancel(): void;
}

/** Interval for polling the driver, seconds: about the shortest that browsers' timers support. */
const POLL_S = 0.004;

/** Loads a program while another one plays; frames continue between polls. */
export function loadProgram(engine: Engine, program: Program): Loading {
  const glPrograms = program.shaders.map((shader) => engine.programs.acquire(shader));
  const assets = engine.assets.hold(program.assets);
  const images = engine.images.hold(program);
  let cancelled = false;
  const release = (): void => {
    for (const glProgram of glPrograms.splice(0)) engine.programs.release(glProgram);
    assets.release();
    images.release();
  };
  return {
    done: wait(engine, glPrograms, [assets.usable, images.settled], () => cancelled).then((ready) => {
      if (!ready) return null;
      return { program, glPrograms: [...glPrograms], errors: glPrograms.flatMap((p) => p.errors), complete: assets.settled, release };
    }),
    cancel: () => {
      if (cancelled) return;
      cancelled = true;
      release();
    },
  };
}

async function wait(
  engine: Engine,
  glPrograms: readonly GlProgram[],
  loaded: readonly Promise<void>[],
  cancelled: () => boolean,
): Promise<boolean> {
  for (;;) {
    engine.programs.poll();
    const linking = engine.copy.state === 'linking' || glPrograms.some((p) => p.state === 'linking');
    if (cancelled() || !linking) break;
    await engine.clock.delay(POLL_S);
  }
  await Promise.all(loaded);
  return !cancelled();
}
