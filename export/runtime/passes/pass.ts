import { PROBE_SIDE_PX } from '../../program/loop-budget.ts';
import type { PassOperation } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import type { Asker, LoopProbe } from '../gl/loop-probe.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Slots } from '../values/slots.ts';
import { createDrawing, createHandOn, type Drawing, GATE } from './drawing.ts';
import type { Imports } from './imports.ts';
import { createSamplers } from './samplers.ts';
import { createUniformSetters } from './uniform-setters.ts';

/** A full-screen pass, drawn once per view or frame. */
export interface Pass {
  run(state: PlayState): void;
}

export interface PassParts {
  readonly gl: WebGL2RenderingContext;
  readonly drawer: PassDrawer;
  readonly clock: FrameClock;
  readonly resources: LiveResources;
  readonly slots: Slots;
  readonly imports: Imports;
  /** The linked program that copies an image. */
  readonly copy: GlProgram;
}

const TRANSPARENT = new Float32Array(4);

/**
 * Decides whether a pass is drawn or only copies its input, because loops of its node exceed their budget
 * (`export/program/loop-budget.ts`).
 */
export interface PassGuard {
  /**
   * Whether loops of the node exceed their budget, in this pass or another pass of the node. All passes of the node then copy their first
   * input.
   */
  readonly bypassed: boolean;
  /** What a pass with loops needs for its probe; null for a pass without loops. */
  readonly loops: {
    readonly probe: LoopProbe;
    /** A linked program: `COPY_SHADER` with a gate. */
    readonly gatedCopy: GlProgram;
    readonly asker: Asker;
    /** Whether to probe the loops in this frame. */
    readonly due: boolean;
  } | null;
}

/** Creates a pass. It copies its first input if its shader does not compile or its guard bypasses it. */
export function createPass(operation: PassOperation, program: GlProgram, parts: PassParts, guard: PassGuard | null): Pass {
  const { gl, drawer, resources } = parts;
  const loops = guard?.loops ?? null;
  const probeTexture = loops?.probe.texture ?? null;
  const handOn = createHandOn(gl, drawer, loops?.gatedCopy ?? parts.copy, operation, resources, parts.imports, probeTexture);
  const own = program.state === 'broken' ? handOn : createOwn(operation, program, parts, probeTexture);
  const destination = operation.target === 'screen' ? null : liveResource(resources, operation.target, 'target');

  const drawProbe = (state: PlayState, widthPx: number, heightPx: number): void => {
    if (!loops?.due) return;
    drawer.begin(loops.probe.framebuffer, 0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, 'replace');
    loops.probe.clear();
    own.draw(state, widthPx, heightPx, GATE.open);
    loops.probe.ask(loops.asker);
    drawer.end();
  };
  const drawPicture = (state: PlayState, widthPx: number, heightPx: number): void => {
    if (guard?.bypassed) {
      handOn.draw(state, widthPx, heightPx, GATE.open);
    } else {
      // The gate lets one of the two draw, which only the GPU can decide without waiting.
      if (loops) handOn.draw(state, widthPx, heightPx, GATE.ifExceeded);
      own.draw(state, widthPx, heightPx, loops ? GATE.unlessExceeded : GATE.open);
    }
    drawer.end();
  };
  return {
    run: (state) => {
      own.prepare(state);
      if (destination) {
        const viewIndex = destination.domain === 'view' ? state.viewIndex : 0;
        const { framebuffer, widthPx, heightPx } = destination.target.back(viewIndex);
        drawProbe(state, widthPx, heightPx);
        drawer.begin(framebuffer, 0, 0, widthPx, heightPx, operation.blend);
        // Pixels that an author's vertex shader does not cover are transparent.
        if (program.shader.geometry === 'moved-quad') gl.clearBufferfv(gl.COLOR, 0, TRANSPARENT);
        drawPicture(state, widthPx, heightPx);
        destination.target.finish(viewIndex);
      } else if (state.view) {
        const { x, y, widthPx, heightPx } = state.view.viewport;
        drawProbe(state, widthPx, heightPx);
        // Over transparency, blending would only read the screen.
        drawer.begin(state.frame.framebuffer, x, y, widthPx, heightPx, state.screenIsEmpty ? 'replace' : operation.blend);
        state.screenIsEmpty = false;
        drawPicture(state, widthPx, heightPx);
      }
    },
  };
}

function createOwn(operation: PassOperation, program: GlProgram, parts: PassParts, probe: WebGLTexture | null): Drawing {
  const { gl, drawer } = parts;
  const samplers = createSamplers(gl, drawer, program, operation, parts.resources, parts.imports);
  const uniforms = createUniformSetters(gl, program, operation, parts.slots, parts.clock, parts.resources);
  return createDrawing(gl, drawer, program, samplers, uniforms, probe);
}
