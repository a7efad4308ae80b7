import { describe, expect, test } from '@jest/globals';
import { compile } from '../../../export/compiler/compile.ts';
import { newProject } from '../../../export/graph/new-project.ts';
import type { Graph } from '../../../export/graph/project.ts';
import type { Program } from '../../../export/program/program.ts';
import { LIBRARY } from '../../../tests/support/library.ts';
import type { MemoryCost } from '../../preview-costs.ts';
import { costAt, costsOf, costWords, leftObjects, overBudget, totalOf } from './cost-state.ts';

/** The camera's picture through filters to the screen. */
function program(filters: readonly string[]) {
  const ids = filters.map((type, i) => [`f${i}-aaaa`, { type, version: 1, params: {} }] as const);
  const chain = ['video-aaaa', ...ids.map(([id]) => id)];
  const graph: Graph = {
    nodes: {
      'video-aaaa': { type: 'source/camera-video', version: 1, params: {} },
      ...Object.fromEntries(ids),
      'screen-aaaa': { type: 'output/screen', version: 1, params: {} },
    },
    wires: [
      ...ids.map(([id], i) => ({ from: { node: chain[i] ?? '', port: 'layer' }, to: { node: id, port: 'inputImage' } })),
      { from: { node: chain.at(-1) ?? '', port: 'layer' }, to: { node: 'screen-aaaa', port: 'layer' } },
    ],
    exposed: { inputs: [], outputs: [] },
  };
  const { output } = compile({
    project: { title: '', graphs: { main: graph }, sources: {}, assets: {}, page: newProject('').page },
    library: LIBRARY,
  });
  if (!output) throw new Error('The project does not compile.');
  return output;
}

test('passes and pictures stand at the node that draws them', () => {
  const made = program(['filter/sepia', 'filter/threshold']);
  const costs = costsOf(made, { measured: [], memory: [], device: 'phone' });
  expect(totalOf(costs.values()).passes).toBe(made.operations.filter(({ kind }) => kind === 'pass').length);
  // One picture of 1080 × 2400 RGBA8 between the two; the second draws on the screen.
  expect(costAt(costs, 'f0-aaaa')).toMatchObject({ passes: 1, targets: 1, bytes: 1080 * 2400 * 4 });
  expect(costAt(costs, 'f1-aaaa')).toMatchObject({ passes: 1, targets: 0, bytes: 0 });
  expect(costAt(costs, 'nothing-aaaa')).toBeNull();
  expect(costWords({ passes: 2, targets: 1, bytes: 3 * 2 ** 20, draws: 2, gpuMs: 0.5 })).toBe('2 passes · 3.0 MB · 0.50 ms');
});

test('a headset draws each pass twice; what is over its budget is said', () => {
  const made = program(['filter/gaussian-blur', 'filter/sobel-edges', 'filter/gaussian-blur']);
  const [phone, headset] = (['phone', 'headset'] as const).map((device) =>
    totalOf(costsOf(made, { measured: [], memory: [], device }).values()),
  );
  if (!phone || !headset) throw new Error('There are two devices.');
  expect(headset.passes).toBe(2 * phone.passes);
  expect(overBudget(phone, 'phone')).toEqual([]);
  expect(overBudget(headset, 'headset')).toEqual([expect.stringMatching(/passes per frame exceed the budget of about 4 for a headset/)]);
});

test('what the preview measured counts for the node of the operation, and for the subgraph that it is in', () => {
  const made = program(['filter/sepia']);
  const pass = made.operations.find(({ kind }) => kind === 'pass');
  if (!pass) throw new Error('There is no pass.');
  const inside = { ...made, operations: made.operations.map((operation) => ({ ...operation, node: `look-aaaa/${operation.node}` })) };
  const costs = costsOf(inside, { measured: [{ id: pass.id, draws: 3, gpuMs: 1.25 }], memory: [], device: 'phone' });
  expect(costAt(costs, 'look-aaaa')).toMatchObject({ draws: 3, gpuMs: 1.25, passes: 1 });
});

describe('the GPU memory of nodes that draw themselves', () => {
  const made = program(['filter/sepia']);
  const withPlaces: Program = {
    ...made,
    assets: [
      { id: 'room', kind: 'capture', path: 'assets/room.capture/capture.json' },
      { id: 'sky', kind: 'image', path: 'assets/sky.png' },
    ],
    operations: made.operations.map((operation) =>
      operation.kind === 'source' ? { ...operation, assets: { file: 'room', sky: 'sky' } } : operation,
    ),
  };
  const node = { kind: 'node', name: 'video-aaaa', objects: 5, bytes: 4e6, isLeft: false } as const;
  const room = { kind: 'asset', name: 'assets/room.capture/capture.json', objects: 9, bytes: 200e6, isLeft: false } as const;
  const bytesOf = (memory: readonly MemoryCost[]): number =>
    costAt(costsOf(withPlaces, { measured: [], memory, device: 'phone' }), 'video-aaaa')?.bytes ?? 0;

  test('stands at the node, with the capture that it draws, of which phones take at most their share', () => {
    expect(bytesOf([node])).toBe(4e6);
    expect(bytesOf([node, { ...room, bytes: 50e6 }])).toBe(54e6);
    expect(bytesOf([node, room])).toBe(4e6 + 128e6);
    expect(
      bytesOf([
        { ...room, name: 'assets/sky.png' },
        { ...node, name: 'other-aaaa' },
      ]),
    ).toBe(0);
  });

  test('is reported if it remains when the node is gone', () => {
    const left = { ...node, isLeft: true };
    expect(bytesOf([left])).toBe(0);
    expect(leftObjects([node, room])).toEqual([]);
    expect(leftObjects([left])).toEqual([expect.stringMatching(/^5 GPU objects \(3\.8 MB\) of the removed node video-aaaa remain\./)]);
  });
});
