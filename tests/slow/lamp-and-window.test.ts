import { mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import type { DeviceName } from '../../export/emulator/profiles.ts';
import { findLampsAtOnce } from '../../nodes/kit/panorama/find-lamps.ts';
import { useBrowser } from '../support/browser.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { serveProject } from '../support/project-page.ts';
import { openXrPage } from '../xr/xr-page.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../examples/a-lamp-and-a-window');
const OUTPUT = resolve(import.meta.dirname, '../output/lamp-and-window');
/** Where the robot stands, and its height. */
const ROBOT = { x: 0.8, z: -0.6, heightM: 0.42 * 1.4 } as const;
/** The lamp and the middle of the window from the center of the panorama (`tools/examples/lit-room.ts`). */
const LAMP = [1.3, 1.4, -1.2] as const;
const WINDOW = [-2, 0.65, -0.2] as const;
const EYE = { heightM: 2.2, fovYRad: 0.9 } as const;
const chromium = useBrowser();

let served: Awaited<ReturnType<typeof serveProject>>;
beforeAll(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  served = await serveProject(EXAMPLE);
});
afterAll(() => served.close());

/** Looks straight down at the robot. */
async function see(device: DeviceName): Promise<{ layer: RgbaImage; errors: readonly string[]; controls: readonly string[] }> {
  const xr = await openXrPage(chromium.browser, served.url, { room: 'studio', device, views: 1, fovYRad: EYE.fovYRad, sizePx: [320, 320] });
  try {
    const controls = await xr.page.locator('#controls-body label').allTextContents();
    await xr.enter();
    await xr.setPose({ position: [ROBOT.x, EYE.heightM, ROBOT.z], quaternion: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] });
    await xr.step(4);
    const [layer, seen] = [await xr.readLayer(), await xr.readComposite()];
    for (const [name, { data, width, height }] of Object.entries({ layer, seen }))
      await sharp(data, { raw: { width, height, channels: 4 } })
        .removeAlpha()
        .png()
        .toFile(join(OUTPUT, `${device}-${name}.png`));
    return { layer, errors: xr.errors, controls };
  } finally {
    await xr.close();
  }
}

/** The pixel of a point of the floor. */
function pixelOf({ width, height }: RgbaImage, x: number, z: number): readonly [x: number, y: number] {
  const perM = height / 2 / (EYE.heightM * Math.tan(EYE.fovYRad / 2));
  return [Math.round(width / 2 + (x - ROBOT.x) * perM), Math.round(height / 2 + (z - ROBOT.z) * perM)];
}

/** A point of the floor in the shadow of a part of the robot at a height. */
function shadowOf([x, y, z]: readonly [number, number, number], atM: number): readonly [x: number, z: number] {
  return [ROBOT.x - (x / y) * atM, ROBOT.z - (z / y) * atM];
}

/** Mean of a channel over 5 × 5 pixels around a point of the floor. */
function meanAt(picture: RgbaImage, [x, z]: readonly [number, number], channel: 1 | 3): number {
  const [px, py] = pixelOf(picture, x, z);
  let sum = 0;
  for (let i = 0; i < 25; i++) sum += pixelAt(picture, px - 2 + (i % 5), py - 2 + Math.floor(i / 5))[channel];
  return sum / 25;
}

const inLampShadow = shadowOf(LAMP, ROBOT.heightM * 0.6);
const inWindowShadow = shadowOf(WINDOW, ROBOT.heightM * 0.35);
/** Beyond the shadow of the lamp, within the light around the robot. */
const lit = shadowOf(LAMP, ROBOT.heightM * 1.2);

test('the search finds the lamp and the window within 2° of where they are', async () => {
  const options = { method: 'solid-angle', lamps: 2, iterations: 1, intensities: 'ranks', clippedShare: 0 } as const;
  const { lamps } = findLampsAtOnce(await decodePanorama(join(EXAMPLE, 'assets/room.hdr')), options);
  const errors = [WINDOW, LAMP].map((at, i) => {
    const [x = 0, y = 0, z = 0] = lamps[i]?.towards ?? [];
    return (Math.acos((x * at[0] + y * at[1] + z * at[2]) / Math.hypot(...at)) * 180) / Math.PI;
  });
  for (const error of errors) expect(error).toBeLessThan(2);
});

test('glasses show the light around the robot with two shadows, each lit by the other light', async () => {
  const { layer, errors, controls } = await see('glasses');
  expect(errors).toEqual([]);
  expect(controls.join(' ')).toMatch(/^Directional Spot Point Distance Intensity Ambient light Rotation$/);
  const [lamp, window, around] = [inLampShadow, inWindowShadow, lit].map((point) => meanAt(layer, point, 1)) as [number, number, number];
  // The base of 0.055 is level 14. The lamp gives a third of the light, and the wide window casts a soft shadow.
  expect(around).toBeGreaterThan(10);
  expect(around - lamp).toBeGreaterThan(2.5);
  expect(around - window).toBeGreaterThan(0.7);
  expect(Math.min(lamp, window)).toBeGreaterThan(5);
});

test('a phone darkens the floor at the same two places', async () => {
  const { layer, errors } = await see('phone');
  expect(errors).toEqual([]);
  const [lamp, window, around] = [inLampShadow, inWindowShadow, lit].map((point) => meanAt(layer, point, 3)) as [number, number, number];
  expect(lamp - around).toBeGreaterThan(40);
  expect(window - around).toBeGreaterThan(12);
});
