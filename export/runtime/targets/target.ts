import { clearAll } from '../gl/clear.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { Multisampling } from './multisampling.ts';
import { createTargetBuffer, type TargetBuffer, type TargetResource } from './target-buffer.ts';

/**
 * A render target of the program with its buffers. Views are drawn one after the other, so they share one buffer if their sizes are equal.
 * A persistent target has two per view, because the previous image is read while the next is drawn; a viewed target has one per view.
 */
export interface Target {
  readonly resource: TargetResource;
  /** Sets the size. Called before the first use in a view. A persistent image is scaled to the new size; others start transparent. */
  resize(viewIndex: number, widthPx: number, heightPx: number): void;
  /** The buffer to draw to. The current `front` stays readable until `finish`. */
  back(viewIndex: number): TargetBuffer;
  /** The buffer drawn last, resolved for reading. May bind framebuffers and disable the scissor test. */
  front(viewIndex: number): TargetBuffer;
  /** The buffer that readers got in the last frame, or null without a size. For a persistent target it is the previous image. */
  peek(viewIndex: number): TargetBuffer | null;
  /** Completes the image in `back`. Resolves samples that other targets draw over, which binds framebuffers. */
  finish(viewIndex: number): void;
  /** Clears all images. */
  clear(): void;
  /** Disposes the buffers of views from `viewCount` on. */
  trim(viewCount: number): void;
  dispose(): void;
}

/** Maximum number of views of a session. */
export const MAX_VIEWS = 2;

interface ViewState {
  front: TargetBuffer | null;
  /** The buffer to draw to in a persistent target; null in others, which draw to `front`. */
  back: TargetBuffer | null;
  unresolved: boolean;
}

/**
 * Creates a target without buffers.
 *
 * @param isViewed Whether something outside of the program may read it at any time: it has samples and buffers per view of its own.
 * @param multisampling Needed for a target with several samples.
 */
export function createTarget(objects: GlObjects, resource: TargetResource, isViewed: boolean, multisampling: Multisampling | null): Target {
  const { gl } = objects;
  const persistent = resource.lifetime === 'persistent';
  const separate = persistent || isViewed;
  // Another target may draw into the same samples next.
  const resolvesAtOnce = resource.samples > 1 && !isViewed;
  const createBuffer = (widthPx: number, heightPx: number): TargetBuffer =>
    createTargetBuffer(objects, resource, widthPx, heightPx, multisampling, isViewed);
  const states: ViewState[] = Array.from({ length: MAX_VIEWS }, () => ({ front: null, back: null, unresolved: false }));
  const [first] = states as [ViewState];
  /** The state to which each view draws; views of equal size share one. */
  const stateOf: ViewState[] = states.map(() => first);

  const at = (viewIndex: number): ViewState => stateOf[viewIndex] ?? first;
  const free = (state: ViewState): void => {
    state.front?.dispose();
    state.back?.dispose();
    state.front = null;
    state.back = null;
    state.unresolved = false;
  };
  return {
    resource,
    resize: (viewIndex, widthPx, heightPx) => {
      const own = states[viewIndex] ?? first;
      const shared = !separate && own !== first && hasSize(first.front, widthPx, heightPx);
      if (shared && own.front) free(own);
      const state = shared ? first : own;
      stateOf[viewIndex] = state;
      if (hasSize(state.front, widthPx, heightPx)) return;
      const before = state.front;
      const front = createBuffer(widthPx, heightPx);
      if (persistent && before) copyScaled(gl, before, front, resource.format === 'r32f' ? gl.NEAREST : gl.LINEAR);
      before?.dispose();
      state.back?.dispose();
      state.front = front;
      state.back = persistent ? createBuffer(widthPx, heightPx) : null;
      state.unresolved = false;
    },
    back: (viewIndex) => present(at(viewIndex).back ?? at(viewIndex).front, resource),
    front: (viewIndex) => present(resolved(at(viewIndex)), resource),
    peek: (viewIndex) => at(viewIndex).back ?? resolved(at(viewIndex)),
    finish: (viewIndex) => {
      const state = at(viewIndex);
      if (state.back) {
        const drawn = state.back;
        state.back = state.front;
        state.front = drawn;
      }
      state.unresolved = true;
      if (!resolvesAtOnce) return;
      const front = resolved(state);
      if (resource.depthRead) front?.readDepth();
    },
    clear: () => {
      for (const { front, back } of states) {
        for (const buffer of [front, back]) if (buffer) clearAll(gl, buffer.resolvedFramebuffer, false);
      }
    },
    trim: (viewCount) => {
      for (let i = viewCount; i < states.length; i++) {
        const state = states[i];
        if (state) free(state);
      }
    },
    dispose: () => {
      for (const state of states) free(state);
    },
  };
}

function resolved(state: ViewState): TargetBuffer | null {
  if (state.unresolved) state.front?.resolve();
  state.unresolved = false;
  return state.front;
}

function hasSize(buffer: TargetBuffer | null, widthPx: number, heightPx: number): boolean {
  return buffer !== null && buffer.widthPx === widthPx && buffer.heightPx === heightPx;
}

function present(buffer: TargetBuffer | null, resource: TargetResource): TargetBuffer {
  if (!buffer) throw new Error(`The target ${resource.id} is used before it has a size.`);
  return buffer;
}

function copyScaled(gl: WebGL2RenderingContext, from: TargetBuffer, to: TargetBuffer, filter: GLenum): void {
  gl.disable(gl.SCISSOR_TEST);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from.resolvedFramebuffer);
  gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to.resolvedFramebuffer);
  gl.blitFramebuffer(0, 0, from.widthPx, from.heightPx, 0, 0, to.widthPx, to.heightPx, gl.COLOR_BUFFER_BIT, filter);
}
