import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { type Eye, eyesOf } from './eyes.ts';
import { openXrPage, readCapture, type XrPage } from './xr-page.ts';

const chromium = useBrowser();
const livingRoom = await readCapture('living_room');
const MODEL = await readFile(resolve(import.meta.dirname, '../../examples/first-light/assets/robot.glb'));

/** A meter tall; its sides are less than 14 cm from its middle. */
const SCALE = 2;
const REACH_M = 0.14 * SCALE;

/** Behind the back of the sofa, seen along -x from the middle of the room. */
const PLACE = [-2.3, 0.3, 0] as const;
const WIDTH = 640;
const HEIGHT = 480;

function robot(hidden: boolean): ProjectText {
  return {
    title: 'Robot behind the sofa',
    nodes: {
      'robot-a1b2': ['source/model', { model: 'robot', playing: false }],
      'place-a1b2': ['objects/transform', { positionM: PLACE, scale: SCALE }],
      'light-a1b2': 'light/directional',
      'scene-a1b2': 'layer/scene',
      ...(hidden && { 'depth-a1b2': 'world/depth', 'hide-a1b2': 'layer/depth-occlusion' }),
      'screen-a1b2': 'output/screen',
    },
    wires: [
      'robot-a1b2.objects -> place-a1b2.objects',
      'place-a1b2.objects -> scene-a1b2.objects',
      'light-a1b2.lights -> scene-a1b2.lights',
      ...(hidden
        ? ['scene-a1b2.layer -> hide-a1b2.layer', 'depth-a1b2.depth -> hide-a1b2.depth', 'hide-a1b2.layer -> screen-a1b2.layer']
        : ['scene-a1b2.layer -> screen-a1b2.layer']),
    ],
    assets: { robot: { path: 'assets/robot.glb', kind: 'model' } },
  };
}

let hiding: ServedExport;
let plain: ServedExport;
beforeAll(async () => {
  hiding = await serveProjectText(robot(true), { 'assets/robot.glb': MODEL });
  plain = await serveProjectText(robot(false), { 'assets/robot.glb': MODEL });
});
afterAll(() => Promise.all([hiding.close(), plain.close()]));

function rayOf({ clipFromView, left, width }: Eye, x: number, y: number): readonly [number, number, number] {
  const [p0 = 1, , , , , p5 = 1, , , p8 = 0, p9 = 0] = clipFromView;
  const right = ((2 * (x + 0.5 - left)) / width - 1 + p8) / p0;
  const up = (1 - (2 * (y + 0.5)) / HEIGHT + p9) / p5;
  return [-1, up, -right];
}

const HALF_TURN = Math.SQRT1_2;

async function look(xr: XrPage, eyeHeightM: number): Promise<void> {
  await xr.setPose({ position: [0, eyeHeightM, 0], quaternion: [0, HALF_TURN, 0, HALF_TURN] });
  await xr.step(3);
}

function covers(layer: RgbaImage, x: number, y: number): boolean {
  return pixelAt(layer, x, y)[3] > 0;
}

interface Tally {
  readonly behind: number;
  readonly before: number;
  readonly wrong: readonly string[];
  /** Mean row of the pixels where the robot comes out from behind the sofa. */
  readonly border: number;
}

/**
 * Compares what the page drew of the robot with the room itself, ray by ray: where the room is nearer than any of the robot
 * there must be nothing of it, where the room is farther than all of it every pixel of it must be there. What lies between the
 * two, and the depth map's own outlines, are left out.
 */
async function tally(xr: XrPage, eye: Eye, layer: RgbaImage, silhouette: RgbaImage): Promise<Tally> {
  const nearM = -PLACE[0] + eye.position[0] - REACH_M;
  const farM = -PLACE[0] + eye.position[0] + REACH_M;
  const STEP = 6;
  const MARGIN = 3;
  const candidates: (readonly [number, number])[] = [];
  for (let y = MARGIN; y < HEIGHT - MARGIN; y += STEP) {
    for (let x = eye.left + MARGIN; x < eye.left + eye.width - MARGIN; x += STEP) {
      const inside = [-MARGIN, 0, MARGIN].every((d) => covers(silhouette, x + d, y) && covers(silhouette, x, y + d));
      if (inside) candidates.push([x, y]);
    }
  }
  const rays = candidates.flatMap(([x, y]) =>
    [
      [0, 0],
      [MARGIN, 0],
      [-MARGIN, 0],
      [0, MARGIN],
      [0, -MARGIN],
    ].map(([dx = 0, dy = 0]) => rayOf(eye, x + dx, y + dy)),
  );
  const distances = await xr.page.evaluate(([origin, list]) => list.map((ray) => scrimEmulator?.current?.measure(origin, ray) ?? null), [
    eye.position,
    rays,
  ] as const);
  const roomM = distances.map((distance, i) => (distance === null ? Number.POSITIVE_INFINITY : distance / Math.hypot(...(rays[i] ?? [1]))));
  let behind = 0;
  let before = 0;
  const wrong: string[] = [];
  const visibleRows: number[] = [];
  candidates.forEach(([x, y], i) => {
    const around = roomM.slice(i * 5, i * 5 + 5);
    const [red, green, blue, alpha] = pixelAt(layer, x, y);
    if (around.every((m) => m < nearM - 0.02)) {
      behind++;
      if (alpha !== 0 || red + green + blue !== 0)
        wrong.push(`(${x}, ${y}) is behind the room at ${around[0]?.toFixed(2)} m, and shows ${alpha}`);
    } else if (around.every((m) => m > farM + 0.02)) {
      before++;
      visibleRows.push(y);
      if (alpha !== 255) wrong.push(`(${x}, ${y}) is before the room at ${around[0]?.toFixed(2)} m, and shows ${alpha}`);
    }
  });
  return { behind, before, wrong, border: Math.max(...visibleRows) };
}

async function tallies(options: EmulatorOptions, eyeHeightM: number): Promise<Tally[]> {
  const given: EmulatorOptions = { room: livingRoom, display: false, ...options };
  const viewport = { width: WIDTH, height: HEIGHT };
  const bare = await openXrPage(chromium.browser, plain.url, given, viewport);
  await bare.enter();
  await look(bare, eyeHeightM);
  const silhouette = await bare.readLayer();
  expect(bare.errors).toEqual([]);
  await bare.close();

  const xr = await openXrPage(chromium.browser, hiding.url, given, viewport);
  await xr.enter();
  await look(xr, eyeHeightM);
  const layer = await xr.readLayer();
  const results: Tally[] = [];
  for (const eye of await eyesOf(xr, WIDTH)) results.push(await tally(xr, eye, layer, silhouette));
  expect(xr.errors).toEqual([]);
  await xr.close();
  return results;
}

describe('a model half behind the sofa of the living room, by the exported page', () => {
  test.each([
    ['one view', { device: 'phone', depth: { sizePx: [WIDTH, HEIGHT] } }, 1],
    ['two views', { device: 'headset', depth: { sizePx: [WIDTH / 2, HEIGHT] } }, 2],
  ] as const)(
    'shows all of what is before it and none of what is behind, and the border moves with the viewer: %s',
    async (_name, options, views) => {
      const borders: number[] = [];
      for (const eyeHeightM of [1.35, 1.6]) {
        const found = await tallies(options as EmulatorOptions, eyeHeightM);
        expect(found).toHaveLength(views);
        for (const { behind, before, wrong } of found) {
          expect(wrong).toEqual([]);
          expect(Math.min(behind, before)).toBeGreaterThan(15);
        }
        borders.push(found[0]?.border ?? 0);
      }
      const [low = 0, high = 0] = borders;
      expect(Math.abs(high - low)).toBeGreaterThan(8);
    },
  );
});
