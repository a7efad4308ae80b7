import { describe, expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';

const WIDTH = 96;
const HEIGHT = 72;
/** Samples per side of a pixel in references. */
const FINE = 4;

const page = useModule('tests/slow/layer-edges.page.ts');

type Node = string | readonly [type: string, params: Readonly<Record<string, unknown>>];

/** A ball at the origin and a thin, tilted bar before it, then `filters` in a row. */
function programOf(antialias: boolean, filters: Readonly<Record<string, Node>>, wires: readonly string[]): Program {
  const ids = ['scene', ...Object.keys(filters)];
  const [last] = ids.slice(-1);
  return compileText(
    projectText({
      nodes: {
        'ball-0000': ['objects/primitive', { shape: 'sphere', sizeM: [1, 1, 1], color: [0.9, 0.15, 0.1, 1] }],
        'bar-0000': ['objects/primitive', { shape: 'box', sizeM: [1.4, 0.05, 0.05], color: [0.95, 0.9, 0.2, 1] }],
        'tilt-0000': ['objects/transform', { positionM: [0, 0, 0.9], rotationRad: [0, 0, 0.3] }],
        'light-0000': 'light/directional',
        'scene-0000': 'layer/scene',
        ...Object.fromEntries(Object.entries(filters).map(([id, node]) => [`${id}-0000`, node])),
        'screen-0000': ['output/screen', { antialias }],
      },
      wires: [
        'ball-0000.objects -> scene-0000.objects',
        'bar-0000.objects -> tilt-0000.objects',
        'tilt-0000.objects -> scene-0000.objects',
        'light-0000.lights -> scene-0000.lights',
        ...wires,
        `${last}-0000.layer -> screen-0000.layer`,
      ],
    }),
  );
}

const FOG = {
  filters: { fog: ['filter/fog', { near: 0.5, far: 1.6, falloff: 2, color: [0.1, 0.6, 1, 1] }] },
  wires: ['scene-0000.layer -> fog-0000.inputImage'],
} as const;

const FOCUSED = {
  filters: { lens: ['filter/depth-of-field', { focus: 1.1, fStop: 2, most: 8 }] },
  wires: ['scene-0000.layer -> lens-0000.inputImage'],
} as const;

/** Behind a filter, so the finished layer is cut. */
const HIDDEN = {
  filters: { same: ['filter/sepia', { amount: 0 }], depth: ['world/depth', { filter: 'nearest' }], hide: 'layer/depth-occlusion' },
  wires: ['scene-0000.layer -> same-0000.inputImage', 'same-0000.layer -> hide-0000.layer', 'depth-0000.depth -> hide-0000.depth'],
} as const;

const draw = (program: Program, scale = 1, wallM = 9): Promise<number[]> =>
  page.call('shoot', program, WIDTH * scale, HEIGHT * scale, wallM);

/** Means of `FINE` × `FINE` pixels, each drawn with one sample. */
async function reference(shape: { filters: Readonly<Record<string, Node>>; wires: readonly string[] }, wallM = 9): Promise<number[]> {
  const fine = await draw(programOf(false, shape.filters, shape.wires), FINE, wallM);
  return Array.from({ length: WIDTH * HEIGHT * 4 }, (_, i) => {
    const [x, y, c] = [(i >> 2) % WIDTH, Math.floor((i >> 2) / WIDTH), i % 4];
    let sum = 0;
    for (let s = 0; s < FINE * FINE; s++) {
      sum += fine[((y * FINE + Math.floor(s / FINE)) * WIDTH * FINE + x * FINE + (s % FINE)) * 4 + c] ?? 0;
    }
    return sum / (FINE * FINE);
  });
}

/** Pixels that the silhouette crosses. */
function edgeOf(picture: readonly number[]): number[] {
  return Array.from({ length: WIDTH * HEIGHT }, (_, i) => i).filter(
    (i) => (picture[i * 4 + 3] ?? 0) > 8 && (picture[i * 4 + 3] ?? 0) < 247,
  );
}

/** Straight color. */
const colorAt = (picture: readonly number[], i: number): number[] =>
  [0, 1, 2].map((c) => ((picture[i * 4 + c] ?? 0) / Math.max(picture[i * 4 + 3] ?? 0, 1)) * 255);

describe('the edge of a multisampled layer', () => {
  test('has the fog of its object', async () => {
    const shown = await draw(programOf(true, FOG.filters, FOG.wires));
    const right = await reference(FOG);
    const edge = edgeOf(shown).filter((i) => (right[i * 4 + 3] ?? 0) > 8);
    expect(edge.length).toBeGreaterThan(100);
    const off = edge.map((i) => Math.max(...colorAt(shown, i).map((v, c) => Math.abs(v - (colorAt(right, i)[c] ?? 0)))));
    // With the depth of one sample, the mean is 72 of 255.
    expect(off.reduce((sum, value) => sum + value, 0) / off.length).toBeLessThan(4);
    // Where the edges of ball and bar meet, the nearest surface beside the pixel may not be the one in it.
    expect(off.filter((value) => value > 48).length).toBeLessThan(3);
  });

  test('is hidden with its object behind the room', async () => {
    const shown = await draw(programOf(true, HIDDEN.filters, HIDDEN.wires), 1, 1.3);
    const right = await reference(HIDDEN, 1.3);
    const isBare = (value: number, i: number): boolean => i % 4 === 3 && (right[i] ?? 0) === 0 && value > 0;
    // With the depth of one sample, half of the ball's edge stays: 36 pixels.
    expect(shown.filter(isBare).length).toBeLessThan(3);
    expect(shown.filter((value, i) => i % 4 === 3 && value > 0).length).toBeGreaterThan(300);
  });

  test('is as sharp as its object', async () => {
    const shown = await draw(programOf(true, FOCUSED.filters, FOCUSED.wires));
    const bare = await draw(programOf(true, FOG.filters, FOG.wires));
    // Beside the ball there is only the bar, which is in focus.
    const isBar = (i: number): boolean => i % 4 === 3 && (i >> 2) % WIDTH < WIDTH / 6;
    const off = shown.flatMap((value, i) => (isBar(i) ? [Math.abs(value - (bare[i] ?? 0))] : []));
    // With the depth of one sample, half of its edge blurs like the sky: by up to 101 of 255.
    expect(Math.max(...off)).toBeLessThan(20);
  });
});
