import type { PassOperation } from '../../program/program.ts';
import { COPY_SAMPLER } from '../gl/copy-shader.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveResources } from '../resources/resources.ts';
import type { Imports } from './imports.ts';
import { createSamplers, type Sampler } from './samplers.ts';
import type { SetUniform } from './uniform-setters.ts';

/** Decides whether shaders with bounded loops draw. */
export interface Gate {
  /** Returns a function that passes the gate to a program. `unit` is the texture unit for the result of the loop probe. */
  setterFor(program: GlProgram, unit: number): () => void;
}

/** A full-screen draw with all inputs of its program. The caller begins and ends the pass. */
export interface Drawing {
  /** Prepares the textures that the draw reads. Call it before the framebuffer of the pass is bound. */
  prepare(state: PlayState): void;
  /** Draws the probe of its loops, where it has one and it is due. Call it before the framebuffer of the pass is bound. */
  probe?(state: PlayState, widthPx: number, heightPx: number): void;
  /** Draws. `widthPx` and `heightPx` are the size of the pass, which may differ from that of the framebuffer. */
  draw(state: PlayState, widthPx: number, heightPx: number): void;
}

/** Creates a full-screen draw. `gate` decides whether a shader with bounded loops draws; null for other shaders. */
export function createDrawing(
  drawer: PassDrawer,
  program: GlProgram,
  samplers: readonly Sampler[],
  uniforms: readonly SetUniform[],
  gate: Gate | null,
): Drawing {
  const setGate = gate?.setterFor(program, samplers.length);
  return {
    prepare: (state) => {
      for (let i = 0; i < samplers.length; i++) samplers[i]?.prepare(state);
    },
    draw: (state, widthPx, heightPx) => {
      drawer.use(program);
      for (let i = 0; i < samplers.length; i++) samplers[i]?.bind(state);
      for (let i = 0; i < uniforms.length; i++) uniforms[i]?.(state, widthPx, heightPx);
      setGate?.();
      drawer.draw();
    },
  };
}

/**
 * Creates a draw that copies the first input image of a pass, as for a muted node. A generator has no input, so the result is transparent.
 */
export function createHandOn(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  copy: GlProgram,
  operation: PassOperation,
  resources: LiveResources,
  imports: Imports,
  gate: Gate | null,
): Drawing {
  const first = operation.samplers.find((sampler) => sampler.source.kind === 'color');
  const handedOn = { ...operation, samplers: first ? [{ ...first, name: COPY_SAMPLER }] : [] };
  const samplers = first ? createSamplers(gl, drawer, copy, handedOn, resources, imports) : [transparent(drawer, copy)];
  return createDrawing(drawer, copy, samplers, [], gate);
}

function transparent(drawer: PassDrawer, copy: GlProgram): Sampler {
  const location = copy.uniform(COPY_SAMPLER);
  return { prepare: () => {}, bind: () => location && drawer.texture(0, location, null, 'linear') };
}
