import type { PassOperation } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import { COPY_SAMPLER } from '../gl/copy-shader.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Target } from '../targets/target.ts';
import type { Slots } from '../values/slots.ts';
import { createSamplers, type Sampler } from './samplers.ts';
import { createUniforms, type SetUniform } from './uniforms.ts';

/** A full-screen pass, ready to be drawn once per view or frame. */
export interface Pass {
  run(state: PlayState): void;
}

export interface PassParts {
  readonly gl: WebGL2RenderingContext;
  readonly drawer: PassDrawer;
  readonly clock: FrameClock;
  readonly resources: LiveResources;
  readonly slots: Slots;
  /** Linked. */
  readonly copy: GlProgram;
}

/** A pass whose shader does not compile hands its first picture on, as a muted node would. */
export function createPass(operation: PassOperation, program: GlProgram, parts: PassParts): Pass {
  const { gl, drawer, copy } = parts;
  if (program.state !== 'broken') {
    const samplers = createSamplers(gl, drawer, program, operation, parts.resources);
    const uniforms = createUniforms(gl, program, operation, parts.slots, parts.clock);
    return assemble(operation, program, samplers, uniforms, parts);
  }
  const first = operation.samplers.find((sampler) => sampler.source.kind === 'color');
  const handedOn = { ...operation, samplers: first ? [{ ...first, name: COPY_SAMPLER }] : [] };
  const samplers = first ? createSamplers(gl, drawer, copy, handedOn, parts.resources) : [transparent(drawer, copy)];
  return assemble(operation, copy, samplers, [], parts);
}

/** What a generator hands on. */
function transparent(drawer: PassDrawer, copy: GlProgram): Sampler {
  const location = copy.uniform(COPY_SAMPLER);
  return { prepare: () => {}, bind: () => location && drawer.texture(0, location, null, 'linear') };
}

function assemble(
  operation: PassOperation,
  program: GlProgram,
  samplers: readonly Sampler[],
  uniforms: readonly SetUniform[],
  parts: PassParts,
): Pass {
  const { drawer } = parts;
  const destination = operation.target === 'screen' ? null : liveResource(parts.resources, operation.target, 'target');

  const drawInto = (state: PlayState, widthPx: number, heightPx: number): void => {
    drawer.use(program);
    for (let i = 0; i < samplers.length; i++) samplers[i]?.bind(state);
    for (let i = 0; i < uniforms.length; i++) uniforms[i]?.(state, widthPx, heightPx);
    drawer.draw();
    drawer.end();
  };
  const drawTarget = (state: PlayState, target: Target, viewIndex: number): void => {
    const { framebuffer, widthPx, heightPx } = target.back(viewIndex);
    drawer.begin(framebuffer, 0, 0, widthPx, heightPx, operation.blend);
    drawInto(state, widthPx, heightPx);
    target.finish(viewIndex);
  };
  return {
    run: (state) => {
      for (let i = 0; i < samplers.length; i++) samplers[i]?.prepare(state);
      if (destination) {
        drawTarget(state, destination.target, destination.domain === 'view' ? state.viewIndex : 0);
      } else if (state.view) {
        const { x, y, widthPx, heightPx } = state.view.viewport;
        drawer.begin(state.frame.framebuffer, x, y, widthPx, heightPx, operation.blend);
        drawInto(state, widthPx, heightPx);
      }
    },
  };
}
