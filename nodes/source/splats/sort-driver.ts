import type { NodeWorker, WorkerService } from '../../kit/runtime.ts';
import { createDepthSort, type DepthSort } from '../../kit/splats/depth-sort.ts';
import type { SortAnswer, SortTask } from './sort-protocol.ts';

/** Keeps splats sorted by a worker, or where there is none by the page itself. */
export interface SortDriver {
  /**
   * Sorts along a direction if it has changed enough.
   *
   * @param direction In the space of the splats.
   * @param isExact Whether the least change counts, as in renders.
   */
  request(direction: Float32Array, isExact: boolean): void;
  /** Gives `use` the newest order, if it was not given yet. The order is valid only in the call; `request` may send it to the worker. */
  take(use: (order: Uint32Array) => void): void;
  /** Resolves when the order for the last direction can be taken; null if it can be already. */
  settle(): Promise<void> | null;
  dispose(): void;
}

/** Below this change of the unit vector, about 0.3 degrees, the order is left as it is. */
const LEAST_CHANGE = 0.005;

export function createSortDriver(workers: WorkerService, positions: Float32Array<ArrayBuffer>): SortDriver {
  const count = positions.length / 3;
  const wanted = Float32Array.of(0, 0, 0);
  const task = { kind: 'sort', direction: Float32Array.of(0, 0, 0), order: new Uint32Array(count) } satisfies SortTask;
  let worker: NodeWorker | null = null;
  let own: DepthSort | null = null;
  let isBusy = false;
  let isFresh = false;
  let settled: { readonly promise: Promise<void>; readonly resolve: () => void } | null = null;

  const isCurrent = (least: number): boolean => {
    let square = 0;
    for (let axis = 0; axis < 3; axis++) square += ((wanted[axis] ?? 0) - (task.direction[axis] ?? 0)) ** 2;
    return square <= least * least;
  };
  const send = (): void => {
    task.direction.set(wanted);
    if (worker) {
      isBusy = true;
      worker.post(task, [task.order.buffer]);
      return;
    }
    own ??= createDepthSort(positions);
    own.sort(task.direction, task.order);
    arrive();
  };
  const arrive = (): void => {
    isFresh = true;
    if (settled && isCurrent(0)) {
      settled.resolve();
      settled = null;
    } else if (settled) send();
  };
  try {
    worker = workers.start({
      onMessage: (answer) => {
        task.order = (answer as SortAnswer).order;
        isBusy = false;
        arrive();
      },
      onFailure: () => {
        worker = null;
        isBusy = false;
        // The buffer is lost with the worker.
        task.order = new Uint32Array(count);
        send();
      },
    });
    const copy = positions.slice();
    worker.post({ kind: 'positions', positions: copy } satisfies SortTask, [copy.buffer]);
  } catch {
    // A browser without workers sorts here.
  }
  return {
    request: (direction, isExact) => {
      wanted.set(direction);
      if (!isBusy && !isCurrent(isExact ? 0 : LEAST_CHANGE)) send();
    },
    take: (use) => {
      if (!isFresh || isBusy) return;
      isFresh = false;
      use(task.order);
    },
    settle: () => {
      if (!isBusy && isCurrent(0)) return null;
      if (!settled) {
        let resolve = () => {};
        const promise = new Promise<void>((done) => {
          resolve = done;
        });
        settled = { promise, resolve };
        if (!isBusy) send();
      }
      return settled?.promise ?? null;
    },
    dispose: () => {
      worker?.dispose();
      settled?.resolve();
    },
  };
}
