import type { FrameClock } from '../clock.ts';

/**
 * GPU work in parts. Each part yields its cost; parts with a sum of 1 are about as much as a frame can take beside its own work, also without
 * a GPU. The work returns what it made.
 */
export type PartedWork<T = void> = Generator<number, T>;

/** What work between frames needs. */
export interface Turns {
  readonly gl: WebGL2RenderingContext;
  readonly delay: FrameClock['delay'];
  /** Whether the work is no longer wanted. */
  readonly isOver: () => boolean;
}

/** Short enough that a fast GPU does several turns between two frames. */
const TURN_S = 0.004;

/** A turn of this cost takes no further part: parts of whole rows have a little less than 1. */
const FULL_TURN = 0.75;

/** Does all parts at once. */
export function workAtOnce<T>(work: PartedWork<T>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value as T;
  }
}

/**
 * Does the parts between frames: each turn does parts with a cost of 1, and waits until the GPU has finished them, so that it never has more
 * than that to do before the next frame.
 *
 * @returns What the work made; null if it was over before. Its `finally` runs then too.
 */
export async function workInTurns<T>(work: PartedWork<T>, { gl, delay, isOver }: Turns): Promise<T | null> {
  for (;;) {
    for (let cost = 0; cost < FULL_TURN; ) {
      if (isOver()) {
        work.return(undefined as T);
        return null;
      }
      const { done, value } = work.next();
      if (done) return value as T;
      cost += value as number;
    }
    await untilDone(gl, delay);
  }
}

/** Resolves when the GPU has done what it was told, or its context is lost. */
async function untilDone(gl: WebGL2RenderingContext, delay: FrameClock['delay']): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  do await delay(TURN_S);
  while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED);
  gl.deleteSync(fence);
}
