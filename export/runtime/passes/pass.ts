import type { PassOperation } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Slots } from '../values/slots.ts';
import { createDrawing, createHandOn, type Drawing, type Gate } from './drawing.ts';
import { createGate, guardDrawing, type PassGuard } from './guarded-drawing.ts';
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

/** Creates a pass. It copies its first input if its shader does not compile or its guard bypasses it. */
export function createPass(operation: PassOperation, program: GlProgram, parts: PassParts, guard: PassGuard | null): Pass {
  const { gl, drawer, resources } = parts;
  const gate = guard?.loops ? createGate(gl, drawer, guard.loops) : null;
  const handOn = createHandOn(gl, drawer, guard?.loops?.gatedCopy ?? parts.copy, operation, resources, parts.imports, gate);
  const own = program.state === 'broken' ? handOn : createOwn(operation, program, parts, gate);
  const drawing = guard === null ? own : guardDrawing(own, handOn, guard, gate, drawer);
  const destination = operation.target === 'screen' ? null : liveResource(resources, operation.target, 'target');

  return {
    run: (state) => {
      drawing.prepare(state);
      if (destination) {
        const viewIndex = destination.domain === 'view' ? state.viewIndex : 0;
        const { framebuffer, widthPx, heightPx } = destination.target.back(viewIndex);
        drawing.probe?.(state, widthPx, heightPx);
        drawer.begin(framebuffer, 0, 0, widthPx, heightPx, operation.blend);
        // Pixels that an author's vertex shader does not cover are transparent.
        if (program.shader.geometry === 'moved-quad') gl.clearBufferfv(gl.COLOR, 0, TRANSPARENT);
        drawing.draw(state, widthPx, heightPx);
        drawer.end();
        destination.target.finish(viewIndex);
      } else if (state.view) {
        const { x, y, widthPx, heightPx } = state.view.viewport;
        drawing.probe?.(state, widthPx, heightPx);
        // Over transparency, blending would only read the screen.
        drawer.begin(state.frame.framebuffer, x, y, widthPx, heightPx, state.screenIsEmpty ? 'replace' : operation.blend);
        state.screenIsEmpty = false;
        drawing.draw(state, widthPx, heightPx);
        drawer.end();
      }
    },
  };
}

function createOwn(operation: PassOperation, program: GlProgram, parts: PassParts, gate: Gate | null): Drawing {
  const { gl, drawer } = parts;
  const samplers = createSamplers(gl, drawer, program, operation, parts.resources, parts.imports);
  const uniforms = createUniformSetters(gl, program, operation, parts.slots, parts.clock, parts.resources);
  return createDrawing(drawer, program, samplers, uniforms, gate);
}
