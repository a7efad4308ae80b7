import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from '@jest/globals';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { hsvFromRgb } from '../../nodes/kit/color-math.ts';
import { makeGallery } from '../../tools/examples/gallery.ts';
import { SECTIONS } from '../../tools/examples/gallery-cells.ts';
import { BLEND_MODES } from '../../tools/examples/gallery-layers.ts';
import { cellFootM, cellKey, RAIL_M } from '../../tools/examples/gallery-place.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import type { CellLook, Deed } from './gallery.page.ts';
import { compileGallery, GALLERY_MOUNTS, loadGallery } from './gallery-kit.ts';

const page = useModule('tests/browser/gallery.page.ts', { width: 408, height: 600, mounts: GALLERY_MOUNTS });
beforeAll(() => page.call('begin', compileGallery(bare(loadGallery())), 'gallery/'));

const CELLS = SECTIONS.flatMap(({ cells, row, column }) =>
  cells.map((cell, i) => ({ cell, key: cellKey(row, column + i), foot: cellFootM(row, column + i) })),
);

/** Within two pixels: 0.03 of a rail. */
function near(height: number): unknown {
  return expect.closeTo(height, -Math.log10(2 * 0.03));
}

/** The wall without what is laid over it: the other picture is `tests/slow/gallery-layers.test.ts`'s. */
function bare({ graphs, ...rest }: Project): Project {
  const { main } = graphs;
  if (!main) throw new Error('There is no main graph.');
  const wires = main.wires.filter(({ to }) => to.node !== 'screen-all');
  const shown = { from: { node: 'wall-all', port: 'layer' }, to: { node: 'screen-all', port: 'layer' } };
  return { ...rest, graphs: { ...graphs, main: { ...main, wires: [...wires, shown] } } };
}

/** Cells as they look in a frame, by their keys. */
async function lookAt(frame: number, deed: Deed = {}): Promise<Readonly<Record<string, CellLook>>> {
  await page.call('playTo', frame, deed);
  expect(await page.call('problems')).toEqual([]);
  const looks = await page.call<CellLook[]>(
    'look',
    CELLS.map(({ foot }) => foot),
  );
  return Object.fromEntries(CELLS.map(({ key }, i) => [key, looks[i] ?? { ball: null, color: [] }]));
}

/** Of a ball on its rail, 0 at the foot and 1 at the top; a pixel is 0.013. */
function heightIn({ ball }: CellLook): number {
  return (ball?.[1] ?? Number.NaN) / RAIL_M;
}

/** Of a ball in a cell, from its middle. */
function placeIn({ ball }: CellLook): readonly number[] {
  return [(ball?.[0] ?? Number.NaN) / RAIL_M, (ball?.[1] ?? Number.NaN) / RAIL_M - 0.5];
}

function hueOf(color: readonly number[]): number {
  const out = [0, 0, 0];
  hsvFromRgb(out, color[0] ?? 0, color[1] ?? 0, color[2] ?? 0);
  return (out[0] ?? 0) * 360;
}

/** A spring of 2 Hz and damping 0.5 at a thirtieth's target each, in steps of a thousandth of a frame. */
function springAt(frame: number, target: (frame: number) => number): number {
  const omega = 4 * Math.PI;
  let [x, v] = [target(0), 0];
  for (let k = 1; k <= frame; k++) {
    for (let step = 0; step < 1000; step++) {
      v -= (omega * omega * (x - target(k)) + omega * v) / 30_000;
      x += v / 30_000;
    }
  }
  return x;
}

function smoothAt(frame: number, target: (frame: number) => number): number {
  let x = target(0);
  for (let k = 1; k <= frame; k++) x += (target(k) - x) * (1 - 2 ** (-1 / 3));
  return x;
}

/** Heights of balls by formulas of their own. */
function expectedHeights(frame: number): Readonly<Record<string, number>> {
  const t = frame / 30;
  const beats = Math.floor(t * 2);
  const steps = (k: number) => Math.floor(k / 15) % 2;
  const unit = (t % 2) / 2;
  return {
    a1: 0.75,
    a2: t % 1,
    a3: unit,
    a4: 0.5 + 0.5 * Math.sin(Math.PI * t),
    a5: 1 - (3 * unit ** 2 - 2 * unit ** 3),
    a6: t % 2 > 1 ? 1 : 0,
    e2: (beats % 5) / 4,
    b2: smoothAt(frame, steps),
    b3: springAt(frame, steps),
    b4: t < 0.25 ? 0 : steps(frame - 7.5),
    b5: 1 - 0.98 ** (frame + 1),
    e3: (beats % 4) / 4,
    e4: [0.1, 0.9, 0.3, 0.7][beats % 4] ?? Number.NaN,
    e6: beats % 2,
    c1: unit,
    c3: 0.6,
    c5: 0.85,
    d6: 0.35,
    f1: t >= 1 ? 0.25 : 0,
    f2: (Math.floor(t * 4) % 5) / 4,
    f3: Math.floor(t / 2) / 4,
    f4: Math.floor((t + 0.5) / 2) / 4,
    g1: 0.5,
    g2: 0,
    g3: 0,
    g4: 0.1,
    f5: 0,
  };
}

function heightsIn(looks: Readonly<Record<string, CellLook>>, keys: Iterable<string>): Readonly<Record<string, number>> {
  return Object.fromEntries([...keys].map((key) => [key, heightIn(looks[key] ?? { ball: null, color: [] })]));
}

function expectHeights(looks: Readonly<Record<string, CellLook>>, expected: Readonly<Record<string, number>>): void {
  const all = Object.fromEntries(Object.entries(expected).map(([key, height]) => [key, near(height)]));
  expect(heightsIn(looks, Object.keys(expected))).toEqual(all);
}

test('the gallery is what the script makes of it', () => {
  const { project: logic, layout } = saveProject(makeGallery(LIBRARY));
  expect(readFileSync('examples/boards/gallery/project.scrim.json', 'utf8')).toBe(logic);
  expect(readFileSync('examples/boards/gallery/project.layout.json', 'utf8')).toBe(layout);
});

/** What every graph needs, besides values, pulses and controls. */
const STAPLES = [
  'source/video-file',
  'source/panorama',
  'light/point',
  'light/spot',
  'light/environment',
  'objects/apply-technique',
  'layer/object-mask',
  'layer/previous-frame',
  'operator/blend',
];

test('it shows every node type of values, pulses and controls, and what else every graph needs', () => {
  const shown = new Set(Object.values(loadGallery().graphs).flatMap(({ nodes }) => Object.values(nodes).map(({ type }) => type)));
  const types = [...LIBRARY.types()].filter((type) => /^(value|pulse|input)\//.test(type) && !hasPose(type) && !ELSEWHERE.includes(type));
  expect([...types, ...STAPLES].filter((type) => !shown.has(type))).toEqual([]);
});

/** Gestures need fingers, device motion a device that moves, and a text needs a label to show it; each has an example of its own. */
const ELSEWHERE = ['input/device-motion', 'input/gestures', 'value/format-text'];

/** Nodes of poses need a room; each has an example of its own. */
function hasPose(type: string): boolean {
  const { inputs = {}, outputs = {} } = LIBRARY.definition(type) ?? {};
  return [...Object.values(inputs), ...Object.values(outputs)].some((port) => port.type === 'pose');
}

test('its choice of blend modes has the words of the operator, in its order', () => {
  const mode = LIBRARY.definition('operator/blend')?.params.mode;
  expect(mode?.type === 'choice' && mode.options.map(({ label }) => label)).toEqual(BLEND_MODES);
});

// The tests go on from one another, as time does.
describe('the gallery', () => {
  test.each([10, 20, 40, 53, 70])('has its balls where the formulas say, in frame %d', async (frame) => {
    expectHeights(await lookAt(frame), expectedHeights(frame));
  });

  test('moves balls by vectors', async () => {
    const looks = await lookAt(80);
    const t = 80 / 30;
    const ring = [0.4 * Math.sin(Math.PI * t), 0.4 * Math.cos(Math.PI * t)];
    expect(looks.c2 && placeIn(looks.c2)).toEqual(ring.map(near));
    // As the smoothed number, from -0.3 to 0.3.
    const glided = smoothAt(80, (frame) => (Math.floor(frame / 15) % 2) * 0.6 - 0.3);
    expect(looks.c6 && placeIn(looks.c6)).toEqual([glided, glided].map(near));
  });

  test('wanders smoothly by noise, and draws by chance with each beat only', async () => {
    const noise: number[] = [];
    const random: number[] = [];
    for (let frame = 86; frame <= 93; frame++) {
      const { b1, e1 } = await lookAt(frame);
      noise.push(b1 ? heightIn(b1) : Number.NaN);
      random.push(e1 ? heightIn(e1) : Number.NaN);
    }
    const jumps = noise.slice(1).map((x, i) => Math.abs(x - (noise[i] ?? 0)));
    expect(Math.max(...jumps)).toBeLessThan(0.1);
    expect(Math.max(...noise) - Math.min(...noise)).toBeGreaterThan(0.02);
    // A beat comes in frame 90.
    const changes = random.slice(1).flatMap((x, i) => (Math.abs(x - (random[i] ?? 0)) > 0.02 ? [87 + i] : []));
    expect(changes).toEqual([90]);
  });

  test('paints boxes by colors', async () => {
    const looks = await lookAt(110);
    const hues = Object.fromEntries(['c4', 'd1', 'd3', 'd5', 'e5'].map((key) => [key, hueOf(looks[key]?.color ?? [])]));
    // 110 frames are 1.667 s of two: five sixths of the way around; the beat is the seventh, so the second of two.
    const expected = { c4: 37.5, d1: 4.6, d3: 300, d5: 120, e5: 221.5 };
    for (const [key, hue] of Object.entries(expected)) expect(Math.abs((hues[key] ?? 0) - hue)).toBeLessThan(12);
    const [, greenOn = 0] = looks.d2?.color ?? [];
    const mixed = looks.d4?.color ?? [];
    const later = await lookAt(125);
    const [, greenOff = 255] = later.d2?.color ?? [];
    expect(greenOn - greenOff).toBeGreaterThan(100);
    expect((mixed[2] ?? 0) - (mixed[0] ?? 0)).toBeGreaterThan(40);
  });

  test('follows its controls, taps and a stick', async () => {
    await lookAt(126, {
      params: [
        ['controls-all/slider-g1', 'value', 0.2],
        ['controls-all/toggle-g2', 'value', true],
        ['controls-all/button-g3', 'presses', 2],
        ['controls-all/choice-g4', 'value', 2],
      ],
      taps: 3,
      stick: [0.3, -0.8],
    });
    const looks = await lookAt(127);
    expectHeights(looks, { g1: 0.2, g2: 1, g3: 0.5, g4: 0.9, f5: 0.75 });
    expect(looks.f6 && placeIn(looks.f6)).toEqual([0.12, -0.32].map(near));
  });

  test('keeps the state of its nodes when it is recompiled with another wire into a counter', async () => {
    const { graphs, ...rest } = bare(loadGallery());
    const { controls } = graphs;
    if (!controls) throw new Error('There is no subgraph of the controls.');
    const beat = { type: 'pulse/every', version: 1, params: { periodS: { value: 0.5 } } };
    const wire = { from: { node: 'beat-g3', port: 'pulse' }, to: { node: 'counter-g3', port: 'up' } };
    const more = { ...controls, nodes: { ...controls.nodes, 'beat-g3': beat }, wires: [...controls.wires, wire] };
    const rewired = { ...rest, graphs: { ...graphs, controls: more } };
    expect(await page.call('recompile', compileGallery(rewired))).toBe('playing');
    const before = await lookAt(128);
    expectHeights(before, { g3: 0.5, f5: 0.75, b5: 1 - 0.98 ** 129 });
    // The new beat comes half a second after it was made, and then every half second.
    expectHeights(await lookAt(149), { g3: 0.75 });
  });

  test('starts over with a reset', async () => {
    await page.call('reset');
    const looks = await lookAt(20);
    expectHeights(looks, { ...expectedHeights(20), g1: 0.5, g2: 0, g3: 0.25, g4: 0.1, f5: 0 });
  });

  test('leaves nothing on the GPU', async () => {
    expect(await page.call('end')).toMatchObject({ textures: 0, framebuffers: 0 });
  });
});
