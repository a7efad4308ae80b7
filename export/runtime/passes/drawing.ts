import { GATE_SAMPLER, GATE_UNIFORM } from '../../program/loop-budget.ts';
import type { PassOperation } from '../../program/program.ts';
import { COPY_SAMPLER } from '../gl/copy-shader.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveResources } from '../resources/resources.ts';
import type { Imports } from './imports.ts';
import { createSamplers, type Sampler } from './samplers.ts';
import type { SetUniform } from './uniforms.ts';

/** Values of the gate in bounded shaders, see `export/program/loop-budget.ts`. */
export const GATE = { open: 0, unlessExceeded: 1, ifExceeded: 2 } as const;
export type Gate = (typeof GATE)[keyof typeof GATE];

/** One full-screen triangle with all that its program is given; the caller begins and ends the pass. */
export interface Drawing {
  /** Before a framebuffer is bound. */
  prepare(state: PlayState): void;
  /** `widthPx` and `heightPx`: the picture that is drawn, whatever it is drawn into. Programs without a gate draw in any case. */
  draw(state: PlayState, widthPx: number, heightPx: number, gate: Gate): void;
}

/** `probe`: what the gate looks at. */
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
      // While a probe is drawn its texture must not be bound to be read.
      if (gateSampler) drawer.texture(samplers.length, gateSampler, gate === GATE.open ? null : probe, 'nearest');
      drawer.draw();
    },
  };
}

/** Hands the first picture on, as a muted node would; a generator has none, and hands on nothing. */
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
