import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { flickerBetween, type Shot } from '../../export/score/flicker.ts';
import { meanOf } from '../../export/score/mean-of.ts';
import { useBrowser } from '../support/browser.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';
import { renderLayers } from '../support/render-layers.ts';

const [WIDTH, HEIGHT] = [320, 240];
const FOCAL_PX = 320;
/** A pillar that hides the left part of a board behind it, before a wall. Meters. */
const [PILLAR_M, BOARD_M, WALL_M] = [1.2, 2, 3];
/** In the lower half of the image, the sensor gives any depth within this distance of the border of the pillar. */
const NOISE_PX = 20;
const WIDTH_PX = 20;
/** The camera steps so that the pillar moves by 4 px. */
const STEP_M = (4 * PILLAR_M) / FOCAL_PX;
const BORDER = [160, 156] as const;
/**
 * Boards one above the other, each with two frames before it. They look the same, but lines wander by noise in space, so each board has
 * other lines: their flicker is between 10 and 19.
 */
const [BOARDS, APART_M] = [8, 2];
const heightM = (board: number): number => APART_M * (board - BOARDS / 2);
const FRAMES = 2 * BOARDS;

const chromium = useBrowser();
let base = '';
const layers: Record<'cut' | 'sketched', Uint8Array[]> = { cut: [], sketched: [] };

/** A number from 0 to 1 that belongs to a place. */
const noise = (x: number, y: number): number => {
  const value = Math.sin(x * 127.1 + y * 311.7) * 43758.5453;
  return value - Math.floor(value);
};

function depthMm(frame: number, x: number, y: number): number {
  const away = x + 0.5 - (BORDER[frame] ?? 0);
  // The noise moves with the pillar.
  if (y >= HEIGHT / 2 && Math.abs(away) < NOISE_PX) return Math.round(1000 * (PILLAR_M + (WALL_M - PILLAR_M) * noise(Math.floor(away), y)));
  return 1000 * (away < 0 ? PILLAR_M : WALL_M);
}

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-sketched-'));
  const intrinsics = { fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 };
  const size = { widthPx: WIDTH, heightPx: HEIGHT, intrinsics };
  const files: Record<string, string | Uint8Array> = {
    'color.png': encode({ width: WIDTH, height: HEIGHT, data: new Uint8Array(WIDTH * HEIGHT * 3).fill(200), channels: 3, depth: 8 }),
  };
  const frames = Array.from({ length: FRAMES }, (_, frame) => {
    const depth = Array.from({ length: WIDTH * HEIGHT }, (_, i) => depthMm(frame % 2, i % WIDTH, Math.floor(i / WIDTH)));
    files[`${frame}.png`] = encode({ width: WIDTH, height: HEIGHT, data: Uint16Array.from(depth), channels: 1, depth: 16 });
    const worldFromCamera = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, (frame % 2) * STEP_M, heightM(Math.floor(frame / 2)), 0, 1];
    return { timeS: frame, color: 'color.png', depth: `${frame}.png`, worldFromCamera };
  });
  const head = { format: 'scrim-session', version: 1, title: 'Pillar', color: size, frameRateHz: 1 };
  files['session.json'] = JSON.stringify({ ...head, depth: { ...size, metresPerUnit: 0.001, kind: 'z' }, frames });
  await writeProject(join(base, 'session'), files);
  const graph: ProjectText = {
    nodes: {
      'depth-a1b2': ['world/depth', { filter: 'nearest' }],
      'board-a1b2': ['objects/primitive', { sizeM: [1.6, 1.2, 0.02], color: [0.9, 0.5, 0.2, 1] }],
      ...Object.fromEntries(
        Array.from({ length: BOARDS }, (_, i) => [
          `place${i}-a1b2`,
          ['objects/transform', { positionM: [0, heightM(i), -BOARD_M - 0.01] }],
        ]),
      ),
      'light-a1b2': 'light/directional',
      'scene-a1b2': 'layer/scene',
      // A filter that changes nothing, after which Depth occlusion hides by the depth of pixels, too.
      'sepia-a1b2': ['filter/sepia', { amount: 0 }],
      'cut-a1b2': 'layer/depth-occlusion',
      'sketch-a1b2': ['operator/sketched-occlusion', { widthPx: WIDTH_PX, surePx: 8 }],
      'over-a1b2': 'operator/over',
      'screen-a1b2': ['output/screen', { antialias: false }],
    },
    wires: [
      ...Array.from({ length: BOARDS }, (_, i) => [
        `board-a1b2.objects -> place${i}-a1b2.objects`,
        `place${i}-a1b2.objects -> scene-a1b2.objects`,
      ]).flat(),
      'light-a1b2.lights -> scene-a1b2.lights',
      'scene-a1b2.layer -> sepia-a1b2.inputImage',
      'sepia-a1b2.layer -> cut-a1b2.layer',
      'depth-a1b2.depth -> cut-a1b2.depth',
      'scene-a1b2.layer -> sketch-a1b2.inputImage',
      'depth-a1b2.depth -> sketch-a1b2.room',
      'depth-a1b2.confidence -> sketch-a1b2.confidence',
      'cut-a1b2.layer -> over-a1b2.top',
      'sketch-a1b2.layer -> over-a1b2.bottom',
      'over-a1b2.layer -> screen-a1b2.layer',
    ],
  };
  await writeProject(join(base, 'project'), { 'project.scrim.json': projectText(graph) });
  const images = await renderLayers(chromium.browser, {
    ...{ project: join(base, 'project'), session: join(base, 'session'), widthPx: WIDTH, heightPx: HEIGHT, frames: FRAMES },
    layers: ['cut-a1b2.layer', 'sketch-a1b2.layer'],
  });
  layers.cut.push(...(images.get('cut-a1b2.layer') ?? []).map(({ data }) => data));
  layers.sketched.push(...(images.get('sketch-a1b2.layer') ?? []).map(({ data }) => data));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const at = (image: Uint8Array | undefined, x: number, y: number): readonly number[] => [
  ...(image?.slice(4 * (y * WIDTH + x), 4 * (y * WIDTH + x) + 4) ?? []),
];

const UPPER = [20, HEIGHT / 2 - 3 * WIDTH_PX] as const;
const LOWER = [HEIGHT / 2 + 2 * WIDTH_PX, HEIGHT - 40] as const;

test('along a border that the sensor is sure of, nothing changes', () => {
  for (let frame = 0; frame < FRAMES; frame++) {
    const changed: string[] = [];
    for (let y = UPPER[0]; y < UPPER[1]; y++) {
      for (let x = 0; x < WIDTH; x++) {
        const [sketched, cut] = [at(layers.sketched[frame], x, y), at(layers.cut[frame], x, y)];
        if (sketched.some((value, i) => value !== cut[i])) changed.push(`${x}, ${y}: ${cut} is ${sketched}`);
      }
    }
    expect(changed.slice(0, 20)).toEqual([]);
  }
  // The board is hidden left of the border and visible right of it.
  expect([at(layers.cut[0], BORDER[0] - 1, 60)[3], at(layers.cut[0], BORDER[0], 60)[3]]).toEqual([0, 255]);
});

/** Whether a pixel is ink: opaque and dark. */
const isInk = (image: Uint8Array | undefined, x: number, y: number): boolean => {
  const [r = 0, , , alpha = 0] = at(image, x, y);
  return alpha > 128 && r < 110;
};

/** Mean absolute difference of alpha from a pixel to the next one, along the rows of an unsure border. */
function roughness(image: Uint8Array | undefined): number {
  let [sum, count] = [0, 0];
  for (let y = LOWER[0]; y < LOWER[1]; y++) {
    for (let x = BORDER[0] - WIDTH_PX; x < BORDER[0] + WIDTH_PX; x++) {
      sum += Math.abs((at(image, x, y)[3] ?? 0) - (at(image, x + 1, y)[3] ?? 0));
      count++;
    }
  }
  return sum / count;
}

describe('along a border in noise', () => {
  test('lines run along the border in place of the specks of the noise', () => {
    const [image] = layers.sketched;
    let rows = 0;
    for (let y = LOWER[0]; y < LOWER[1]; y++) {
      const ink = Array.from({ length: 2 * WIDTH_PX }, (_, i) => isInk(image, BORDER[0] - WIDTH_PX + i, y)).filter((is) => is).length;
      if (ink > 0) rows++;
      expect(ink).toBeLessThan(WIDTH_PX);
    }
    expect(rows).toBeGreaterThan(0.8 * (LOWER[1] - LOWER[0]));
    expect(roughness(image)).toBeLessThan(0.5 * roughness(layers.cut[0]));
  });

  test('what is far from it is as it was', () => {
    for (const x of [40, BORDER[0] - 4 * WIDTH_PX, BORDER[0] + 4 * WIDTH_PX, 280]) {
      expect(at(layers.sketched[0], x, 180)).toEqual(at(layers.cut[0], x, 180));
    }
  });

  test('lines stay on the board while the camera moves', () => {
    const shot = (frame: number): Shot => ({
      widthPx: WIDTH,
      heightPx: HEIGHT,
      camera: { fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: WIDTH / 2, cyPx: HEIGHT / 2 },
      worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, frame * STEP_M, 0, 0, 1],
      depthM: Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
        const [x, y] = [i % WIDTH, Math.floor(i / WIDTH)];
        return y >= LOWER[0] && y < LOWER[1] && Math.abs(x - BORDER[0]) < 2 * WIDTH_PX ? BOARD_M : 0;
      }),
    });
    const flicker = (pixels: readonly Uint8Array[]): number[] => {
      const images = pixels.map((layer) => ({ widthPx: WIDTH, heightPx: HEIGHT, pixels: overGray(layer) }));
      return images.flatMap((now, i) => {
        const before = images[i - 1];
        return i % 2 === 1 && before ? [meanOf([flickerBetween(shot(0), before, shot(1), now)])] : [];
      });
    };
    const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value / values.length, 0);
    const [cut, sketched] = [flicker(layers.cut), flicker(layers.sketched)];
    console.info(
      `flicker: ${mean(cut).toFixed(1)} cut, ${mean(sketched).toFixed(1)} sketched: ${sketched.map((f) => f.toFixed(1)).join(' ')}`,
    );
    expect(mean(sketched)).toBeLessThan(0.8 * mean(cut));
  });
});

/** A layer with straight alpha over the gray of the camera video. */
function overGray(pixels: Uint8Array): Uint8Array {
  return pixels.map((value, i) => {
    const alpha = (pixels[i - (i % 4) + 3] ?? 0) / 255;
    return Math.round(value * alpha + 200 * (1 - alpha));
  });
}
