/** A window that slides over the vertices of a mesh, so that all are visited within some frames. */
export interface VertexWindow {
  /** The vertices of the last `advance`: from `first`, `count` in number. A window that runs over the last vertex ends there. */
  readonly first: number;
  readonly count: number;
  /** Says that all vertices have to be visited again, beginning where the window is. */
  restart(): void;
  /**
   * Moves the window on.
   *
   * @param deltaS Seconds since the previous frame; 0: not known.
   * @param isWhole Whether the window takes all vertices that are left at once.
   * @returns False if no vertex is left. `count` is 0 then.
   */
  advance(deltaS: number, isWhole: boolean): boolean;
}

/** A frame that takes at most this times the shortest one came in time. */
const IN_TIME = 1.25;
const GROWTH = 1.25;
const SHRINKAGE = 0.7;
/** So much longer the shortest frame is taken to be with each frame, in case the display has become slower. */
const FORGETTING = 1.001;

/**
 * Creates a window for a mesh. It is as large as all vertices over `frames`, or larger as long as frames come in time (Dupont de Dinechin and
 * Paljic 2020, §3.1). So all vertices are visited within `frames` calls of `advance` after the last `restart`.
 *
 * @param frames At least 1.
 *
 * @example
 * const window = createVertexWindow(200_000, 30);
 * while (window.advance(0, false)) update(window.first, window.count);
 */
export function createVertexWindow(vertexCount: number, frames: number): VertexWindow {
  // A window ends at the last vertex, which takes a frame more.
  const least = Math.min(vertexCount, Math.ceil(vertexCount / Math.max(1, frames - 1)));
  let size = least;
  let next = 0;
  let left = vertexCount;
  let shortestS = Infinity;
  const window = {
    first: 0,
    count: 0,
    restart: () => {
      left = vertexCount;
    },
    advance: (deltaS: number, isWhole: boolean) => {
      if (deltaS > 0) {
        shortestS = Math.min(shortestS * FORGETTING, deltaS);
        const isInTime = deltaS <= IN_TIME * shortestS;
        size = Math.min(vertexCount, Math.max(least, Math.ceil(size * (isInTime ? GROWTH : SHRINKAGE))));
      }
      if (isWhole && left > 0) {
        next = 0;
        left = vertexCount;
      }
      window.first = next;
      window.count = Math.min(isWhole ? vertexCount : size, left, vertexCount - next);
      left -= window.count;
      next = (next + window.count) % vertexCount;
      return window.count > 0;
    },
  };
  return window;
}
