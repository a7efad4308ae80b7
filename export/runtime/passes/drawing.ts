import { GATE_SAMPLER, GATE_UNIFORM } from '../../program/loop-budget.ts';
import type { PassOperation } from '../../program/program.ts';
import { COPY_SAMPLER } from '../gl/copy-shader.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveResources } from '../resources/resources.ts';
import type { Imports } from './imports.ts';
import { createSamplers, type Sampler } from './samplers.ts';
import type { SetUniform } from './uniform-setters.ts';

/** Values of the gate uniform in bounded shaders, see `export/program/loop-budget.ts`. */
export const GATE = { open: 0, unlessExceeded: 1, ifExceeded: 2 } as const;
export type Gate = (typeof GATE)[keyof typeof GATE];

/** A full-screen draw with all inputs of its program. The caller begins and ends the pass. */
export interface Drawing {
  /** Prepares the textures that the draw reads. Call it before the framebuffer of the pass is bound. */
  prepare(state: PlayState): void;
  /**
   * Draws. `widthPx` and `heightPx` are the size of the pass, which may differ from that of the framebuffer. `gate` decides whether a
   * bounded shader draws; programs without a gate always draw.
   */
  draw(state: PlayState, widthPx: number, heightPx: number, gate: Gate): void;
}

/** Creates a full-screen draw. `probe` is the texture with the result of the loop probe, which the gate reads. */
export function createDrawing(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  program: GlProgram,
  samplers: readonly Sampler[],
  uniforms: readonly SetUniform[],
  probe: WebGLTexture | null,
): Drawing {
  const gateUniform = program.uniform(GATE_UNIFORM);
  const gateSampler = program.uniform(GATE_SAMPLER);
  return {
    prepare: (state) => {
      for (let i = 0; i < samplers.length; i++) samplers[i]?.prepare(state);
    },
    draw: (state, widthPx, heightPx, gate) => {
      drawer.use(program);
      for (let i = 0; i < samplers.length; i++) samplers[i]?.bind(state);
      for (let i = 0; i < uniforms.length; i++) uniforms[i]?.(state, widthPx, heightPx);
      if (gateUniform) gl.uniform1i(gateUniform, gate);
      // The probe must not be bound for reading while it is drawn.
      if (gateSampler) drawer.texture(samplers.length, gateSampler, gate === GATE.open ? null : probe, 'nearest');
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
  probe: WebGLTexture | null,
): Drawing {
  const first = operation.samplers.find((sampler) => sampler.source.kind === 'color');
  const handedOn = { ...operation, samplers: first ? [{ ...first, name: COPY_SAMPLER }] : [] };
  const samplers = first ? createSamplers(gl, drawer, copy, handedOn, resources, imports) : [transparent(drawer, copy)];
  return createDrawing(gl, drawer, copy, samplers, [], probe);
}

function transparent(drawer: PassDrawer, copy: GlProgram): Sampler {
  const location = copy.uniform(COPY_SAMPLER);
  return { prepare: () => {}, bind: () => location && drawer.texture(0, location, null, 'linear') };
}
