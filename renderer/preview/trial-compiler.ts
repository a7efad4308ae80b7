import type { LinkedShader } from '../../export/program/program.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { createGlObjects, type GlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createProgramCache } from '../../export/runtime/gl/program-cache.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';

type Trials = Extract<ToPreview, { kind: 'trials' }>;

/** Compiles shaders only for the errors of the driver. */
export interface TrialCompiler {
  /** Compiles shaders and sends the errors of the driver. Answers only the newest request. */
  compile(trials: Trials): void;
}

const POLL_S = 0.004;

/** Creates a trial compiler. It uses a GL context of its own, because there may be no player, and a player disposes its context. */
export function createTrialCompiler(clock: FrameClock, send: (message: FromPreview) => void): TrialCompiler {
  let objects: GlObjects | null = null;
  let newest: Trials | null = null;

  async function run(trials: Trials): Promise<void> {
    if (objects === null || objects.gl.isContextLost()) objects = createContext();
    if (objects === null) return;
    const programs = createProgramCache(objects);
    const tried = trials.shaders.map((shader: LinkedShader) => programs.acquire(shader));
    while (newest === trials && !objects.gl.isContextLost() && tried.some(({ state }) => state === 'linking')) {
      programs.poll();
      await clock.delay(POLL_S);
    }
    const errors = tried.flatMap((program) => program.errors.map(({ shaderId, stage, log }) => ({ shaderId, stage, log })));
    programs.dispose();
    if (newest === trials) send({ kind: 'trial-errors', revision: trials.revision, errors });
  }

  return {
    compile: (trials) => {
      newest = trials;
      void run(trials);
    },
  };
}

/** Creates a GL context; null if the browser does not support WebGL 2, which the player reports. */
function createContext(): GlObjects | null {
  const canvas = document.createElement('canvas');
  canvas.width = 1;
  canvas.height = 1;
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false });
  return gl && createGlObjects(gl);
}
