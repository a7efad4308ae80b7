import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { AssetService } from '../../kit/assets.ts';
import type { WorkerListener, WorkerService } from '../../kit/runtime.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { createSortDriver } from './sort-driver.ts';
import type { SortAnswer, SortTask } from './sort-protocol.ts';
import { serve, type WorkerScope } from './worker.ts';

/** x, y, z of three splats: along −z they stand in the order 2, 0, 1 from far to near. */
const POSITIONS = Float32Array.of(0, 0, -2, 0, 0, -1, 1, 0, -3);

/** Workers that answer when the test says so. Buffers that were sent are emptied, as by a transfer. */
function manualWorkers() {
  const answers: (() => void)[] = [];
  let listener: WorkerListener | null = null;
  let disposed = 0;
  const scope: WorkerScope = { onmessage: null, postMessage: (answer: SortAnswer) => answers.push(() => listener?.onMessage(answer)) };
  serve(scope);
  const workers: WorkerService = {
    start: (started) => {
      listener = started;
      return {
        post: (message, transfer) => scope.onmessage?.({ data: structuredClone(message, { transfer: [...transfer] }) as SortTask }),
        dispose: () => {
          disposed++;
        },
      };
    },
  };
  return { workers, answers, fail: () => listener?.onFailure('lost'), disposed: () => disposed };
}

function taken(driver: ReturnType<typeof createSortDriver>): number[] | null {
  let order: number[] | null = null;
  driver.take((indices) => {
    order = [...indices];
  });
  return order;
}

test('sorts in the worker, and gives each order once', () => {
  const { workers, answers, disposed } = manualWorkers();
  const driver = createSortDriver(workers, POSITIONS);
  driver.request(Float32Array.of(0, 0, -1), false);
  expect(taken(driver)).toBeNull();
  answers.shift()?.();
  expect(taken(driver)).toEqual([2, 0, 1]);
  expect(taken(driver)).toBeNull();
  // A turn of less than 0.3 degrees asks for no other order; a render counts the least turn.
  driver.request(Float32Array.of(0.001, 0, -1), false);
  expect(answers).toHaveLength(0);
  driver.request(Float32Array.of(0.001, 0, -1), true);
  expect(answers).toHaveLength(1);
  driver.dispose();
  expect(disposed()).toBe(1);
});

test('a render waits for the order of its own direction, though another is being sorted', async () => {
  const { workers, answers } = manualWorkers();
  const driver = createSortDriver(workers, POSITIONS);
  driver.request(Float32Array.of(0, 0, -1), true);
  driver.request(Float32Array.of(0, 0, 1), true);
  let isSettled = false;
  const settled = driver.settle()?.then(() => {
    isSettled = true;
  });
  answers.shift()?.();
  await Promise.resolve();
  expect(isSettled).toBe(false);
  answers.shift()?.();
  await settled;
  expect(taken(driver)).toEqual([1, 0, 2]);
  expect(driver.settle()).toBeNull();
});

test('a worker that ends, or cannot be started, leaves the sorting to the page', () => {
  const lost = manualWorkers();
  const driver = createSortDriver(lost.workers, POSITIONS);
  driver.request(Float32Array.of(0, 0, -1), false);
  lost.fail();
  expect(taken(driver)).toEqual([2, 0, 1]);
  driver.request(Float32Array.of(0, 0, 1), false);
  expect(taken(driver)).toEqual([1, 0, 2]);
  const refusing: WorkerService = {
    start: () => {
      throw new Error('No worker.');
    },
  };
  const alone = createSortDriver(refusing, POSITIONS);
  alone.request(Float32Array.of(0, 0, -1), false);
  expect(taken(alone)).toEqual([2, 0, 1]);
});

/** What it looks like is proved on pixels, in `tests/browser/splats.test.ts`. */
test('draws nothing until the splats have loaded, and releases them', () => {
  const log: string[] = [];
  const handle = { kind: 'splats', value: null, settled: Promise.resolve(), release: () => log.push('released') } as const;
  const assets = { splats: (id: string) => log.push(id) && handle } as Partial<AssetService> as AssetService;
  const { ctx } = fakeContext(definition, { params: { file: 'vase' }, services: { assets, gl: {} as never, workers: {} as never } });
  const node = create(ctx);
  node.update({} as never);
  node.draw?.({ view: {} } as never);
  expect(node.settle?.()).toBeNull();
  node.dispose();
  expect(log).toEqual(['vase', 'released']);
});
