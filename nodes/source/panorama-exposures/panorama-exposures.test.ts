import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { EnvironmentAsset } from '../../kit/assets.ts';
import type { FoundLamps } from '../../kit/panorama/found-lamps.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import type { WorkerService } from '../../kit/runtime.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { type MergeTask, serve, type WorkerScope } from './worker.ts';

/** A gray panorama that gets brighter to the right. */
function ramp(most: number, widthPx = 64): PanoramaPixels {
  const data = Uint8Array.from({ length: widthPx * 32 * 4 }, (_, i) =>
    i % 4 === 3 ? 255 : Math.min(255, Math.round((((i >> 2) % widthPx) / widthPx) * most)),
  );
  return { widthPx, heightPx: 32, channels: 4, data };
}

/** Files that have loaded, and a worker that answers at once. */
function stand(files: Readonly<Record<string, PanoramaPixels | null>>, held = false) {
  const log: string[] = [];
  const created: PanoramaPixels[] = [];
  const given: EnvironmentAsset['lamps'][] = [];
  const values = Object.fromEntries(
    Object.entries(files).map(([id, pixels]) => [
      id,
      pixels && ({ readPixels: () => ({ ...pixels, data: pixels.data.slice() }) } as unknown as EnvironmentAsset),
    ]),
  );
  const workers: WorkerService = {
    start: ({ onMessage }) => {
      log.push('start');
      const scope: WorkerScope = { onmessage: null, postMessage: (answer) => onMessage(answer) };
      serve(scope);
      return { post: (data) => scope.onmessage?.({ data: data as MergeTask }), dispose: () => log.push('end') };
    },
  };
  const assets = {
    environment: (id: string) => ({
      kind: 'environment',
      value: values[id] ?? null,
      settled: Promise.resolve(),
      release: () => log.push(`release ${id}`),
    }),
    createEnvironment: (pixels: PanoramaPixels, lamps: EnvironmentAsset['lamps']) => {
      created.push(pixels);
      given.push(lamps);
      return { ready: true, dispose: () => log.push('dispose') };
    },
  };
  const params = Object.fromEntries(Object.keys(files).map((id, i) => [i === 0 ? 'file' : `file${i + 1}`, id]));
  const { ctx, reports } = fakeContext(definition, {
    params: { ...params, exposure: 1, shots: '2' },
    services: { assets, workers } as never,
  });
  (ctx.clock as { held: boolean }).held = held;
  const node = create(ctx);
  const update = () => {
    node.update({} as never);
    return ctx.outputs.environment;
  };
  return { node, update, log, created, given, reports, values };
}

const filesLoaded = () => new Promise((resolve) => setImmediate(resolve));

test('outputs nothing until the worker has merged its files, then one panorama in half floats', async () => {
  const { node, update, log, created, reports } = stand({ bright: ramp(250), dark: ramp(120) });
  expect(update()).toEqual({ asset: null, intensity: 2, rotationRad: 0 });
  await filesLoaded();
  expect(update().asset).not.toBeNull();
  expect(created.map(({ widthPx, channels, data }) => [widthPx, channels, data instanceof Uint16Array])).toEqual([[64, 4, true]]);
  expect(reports).toEqual([]);
  node.dispose();
  expect(log).toEqual(['start', 'end', 'dispose', 'release bright', 'release dark']);
});

test('passes on the lamps that the first shot stores for just these shots', async () => {
  const { update, given, values } = stand({ bright: ramp(250), dark: ramp(120) });
  const found = {} as FoundLamps;
  const lamps = { 'solid-angle 3 0.5': null, 'bright + dark, 0: solid-angle 3 0.5': found, 'bright + other, 0: solid-angle 3 0.5': null };
  Object.assign(values.bright ?? {}, { lamps });
  await filesLoaded();
  update();
  expect(given).toEqual([{ 'solid-angle 3 0.5': found }]);
});

test('in renders merges before the first frame, without a worker', () => {
  const { update, log, created } = stand({ bright: ramp(250), dark: ramp(120) }, true);
  expect(update().asset).not.toBeNull();
  expect([created.length, log]).toEqual([1, []]);
});

test('uses the first shot where they do not fit together, and says why', async () => {
  const { update, reports, values } = stand({ bright: ramp(250), other: ramp(120, 32) });
  await filesLoaded();
  expect(update().asset).toBe(values.bright);
  expect(reports).toEqual([expect.objectContaining({ code: 'SCR068', message: expect.stringMatching(/shot 2 has 32 × 32 pixels/) })]);
});

test('says where lamps are white in all shots', async () => {
  const { update, reports } = stand({ bright: ramp(900), dark: ramp(450) });
  await filesLoaded();
  update();
  expect(reports).toEqual([
    expect.objectContaining({ code: 'SCR068', severity: 'info', message: expect.stringMatching(/white in all shots/) }),
  ]);
});

test('a file that did not load is left out; without files there is nothing', async () => {
  const { update, reports, values } = stand({ bright: ramp(250), missing: null });
  await filesLoaded();
  expect(update().asset).toBe(values.bright);
  expect(reports).toHaveLength(1);
  expect(stand({}).update().asset).toBeNull();
});
