import type { LinkedShader } from '../../export/program/program.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { createGlObjects, type GlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createProgramCache } from '../../export/runtime/gl/program-cache.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';

type Trials = Extract<ToPreview, { kind: 'trials' }>;

/** Compiles shaders that are not for drawing. */
export interface ShaderTrials {
  /** The newest is answered. */
  take(trials: Trials): void;
}

const POLL_S = 0.004;

/** On a context of its own: there may be no player yet, and a player's context ends with it. */
export function createShaderTrials(clock: FrameClock, send: (message: FromPreview) => void): ShaderTrials {
  let objects: GlObjects | null = null;
  let newest: Trials | null = null;

  async function compile(trials: Trials): Promise<void> {
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
    take: (trials) => {
      newest = trials;
      void compile(trials);
    },
  };
}

/** Null where the browser has no WebGL 2, which the player reports. */
function createContext(): GlObjects | null {
  const canvas = document.createElement('canvas');
  canvas.width = 1;
  canvas.height = 1;
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false });
  return gl && createGlObjects(gl);
}
