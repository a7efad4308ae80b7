import { createDepthSort, type DepthSort } from '../../kit/splats/depth-sort.ts';
import type { SortAnswer, SortTask } from './sort-protocol.ts';

/** The part of a worker's global scope that is used. */
export interface WorkerScope {
  onmessage: ((event: { readonly data: SortTask }) => void) | null;
  postMessage(answer: SortAnswer, transfer: ArrayBuffer[]): void;
}

/** Sorts splats in a worker: answers each direction with the order, in the buffer of the message. */
export function serve(scope: WorkerScope): void {
  let depthSort: DepthSort | null = null;
  scope.onmessage = ({ data }) => {
    if (data.kind === 'positions') {
      depthSort = createDepthSort(data.positions);
      return;
    }
    depthSort?.sort(data.direction, data.order);
    scope.postMessage({ order: data.order }, [data.order.buffer]);
  };
}
