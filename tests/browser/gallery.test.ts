import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import type { Program } from '../../export/program/program.ts';
import { hsvFromRgb } from '../../nodes/kit/color-math.ts';
import { cellFootM, cellKey, makeGallery, RAIL_M } from '../../tools/examples/gallery.ts';
import { ROWS } from '../../tools/examples/gallery-cells.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import type { CellLook, Deed } from './gallery.page.ts';

const chromium = useBrowser();
let page: PageModule;

const CELLS = ROWS.flatMap((cells, row) =>
  cells.map((cell, column) => ({ cell, key: cellKey(row, column), foot: cellFootM(row, column) })),
);

/** Within two pixels: 0.03 of a rail. */
function near(height: number): unknown {
  return expect.closeTo(height, -Math.log10(2 * 0.03));
}

function project() {
  const text = (name: string) => readFileSync(`examples/gallery/${name}`, 'utf8');
  const { output } = loadProject({ project: text('project.scrim.json'), layout: text('project.layout.json'), sources: {} });
  if (!output) throw new Error('The gallery cannot be read.');
  return output;
}

function program(): Program {
  const { output, diagnostics } = compile({ project: project(), library: LIBRARY });
  expect(diagnostics).toEqual([]);
  if (!output) throw new Error('The gallery does not compile.');
  return output;
}

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/gallery.page.ts', { width: 960, height: 720 });
  await page.call('begin', program());
}, 60_000);

afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

/** Cells as they look in a frame, by their keys. */
async function lookAt(frame: number, deed: Deed = {}): Promise<Readonly<Record<string, CellLook>>> {
  await page.call('playTo', frame, deed);
  expect(await page.call('problems')).toEqual([]);
  const looks = await page.call<CellLook[]>(
    'look',
    CELLS.map(({ foot }) => [foot[0], foot[1]]),
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
    a8: t % 2 > 1 ? 1 : 0,
    b1: (beats % 5) / 4,
    b2: smoothAt(frame, steps),
    b3: springAt(frame, steps),
    b4: t < 0.25 ? 0 : steps(frame - 7.5),
    b5: 1 - 0.98 ** (frame + 1),
    b6: (beats % 4) / 4,
    b7: [0.1, 0.9, 0.3, 0.7][beats % 4] ?? Number.NaN,
    b8: beats % 2,
    c1: unit,
    c3: 0.6,
    c5: 0.85,
    c8: 0.35,
    d7: t >= 1 ? 0.25 : 0,
    d8: (Math.floor(t * 4) % 5) / 4,
    e1: Math.floor(t / 2) / 4,
    e2: Math.floor((t + 0.5) / 2) / 4,
    e3: 0.5,
    e4: 0,
    e5: 0,
    e6: 0.1,
    e7: 0,
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
  expect(readFileSync('examples/gallery/project.scrim.json', 'utf8')).toBe(logic);
  expect(readFileSync('examples/gallery/project.layout.json', 'utf8')).toBe(layout);
});

test('it shows every node type of values, pulses and controls', () => {
  const shown = new Set(CELLS.flatMap(({ cell }) => Object.values(cell.nodes).map(([type]) => type)));
  const types = [...LIBRARY.types()].filter((type) => /^(value|pulse|input)\//.test(type));
  expect(types.filter((type) => !shown.has(type))).toEqual([]);
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
    expect(looks.c7 && placeIn(looks.c7)).toEqual([glided, glided].map(near));
  });

  test('wanders smoothly by noise, and draws by chance with each beat only', async () => {
    const noise: number[] = [];
    const random: number[] = [];
    for (let frame = 86; frame <= 93; frame++) {
      const { a6, a7 } = await lookAt(frame);
      noise.push(a6 ? heightIn(a6) : Number.NaN);
      random.push(a7 ? heightIn(a7) : Number.NaN);
    }
    const jumps = noise.slice(1).map((x, i) => Math.abs(x - (noise[i] ?? 0)));
    expect(Math.max(...jumps)).toBeLessThan(0.1);
    expect(Math.max(...noise) - Math.min(...noise)).toBeGreaterThan(0.02);
    // A beat comes in frame 90.
    const changes = random.slice(1).flatMap((x, i) => (Math.abs(x - (random[i] ?? 0)) > 0.02 ? [87 + i] : []));
    expect(changes).toEqual([90]);
  });

  test('paints boxes by colours', async () => {
    const looks = await lookAt(110);
    const hues = Object.fromEntries(['c4', 'd1', 'd3', 'd5', 'd6'].map((key) => [key, hueOf(looks[key]?.color ?? [])]));
    // 110 frames are 1.667 s of two: five sixths of the way around; the beat is the seventh, so the second of two.
    const expected = { c4: 37.5, d1: 4.6, d3: 300, d5: 120, d6: 221.5 };
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
        ['slider-e3', 'value', 0.2],
        ['toggle-e4', 'value', true],
        ['button-e5', 'presses', 2],
        ['choice-e6', 'value', 2],
      ],
      taps: 3,
      stick: [0.3, -0.8],
    });
    const looks = await lookAt(127);
    expectHeights(looks, { e3: 0.2, e4: 1, e5: 0.5, e6: 0.9, e7: 0.75 });
    expect(looks.e8 && placeIn(looks.e8)).toEqual([0.12, -0.32].map(near));
  });

  test('keeps what its nodes remember when it is compiled anew, with another wire into a counter', async () => {
    const { graphs, ...rest } = project();
    const { main } = graphs;
    if (!main) throw new Error('There is no main graph.');
    const wire = { from: { node: 'beat-all', port: 'pulse' }, to: { node: 'counter-e5', port: 'up' } };
    const rewired = { ...rest, graphs: { ...graphs, main: { ...main, wires: [...main.wires, wire] } } };
    const { output } = compile({ project: rewired, library: LIBRARY });
    expect(await page.call('recompile', output)).toBe('playing');
    const before = await lookAt(128);
    expectHeights(before, { e5: 0.5, e7: 0.75, b5: 1 - 0.98 ** 129 });
    // The next beat comes in frame 135.
    expectHeights(await lookAt(136), { e5: 0.75 });
  });

  test('starts over with a reset', async () => {
    await page.call('reset');
    const looks = await lookAt(20);
    expectHeights(looks, { ...expectedHeights(20), e3: 0.5, e4: 0, e5: 0.25, e6: 0.1, e7: 0 });
  });

  test('leaves nothing on the GPU', async () => {
    expect(await page.call('end')).toMatchObject({ textures: 0, framebuffers: 0 });
  });
});
