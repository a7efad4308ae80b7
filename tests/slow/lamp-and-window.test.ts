import { mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import type { DeviceName } from '../../export/emulator/profiles.ts';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { captureTargets, type Direction } from '../../nodes/kit/panorama/capture-targets.ts';
import { findLampsAtOnce } from '../../nodes/kit/panorama/find-lamps.ts';
import { useBrowser } from '../support/browser.ts';
import { decodePanorama } from '../support/decode-panorama.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { angleDeg, barOf, lampFrom, type Place, poseFrom, storedPanorama, takePhotos, untilReady } from '../support/panorama-page.ts';
import { eventually } from '../support/patience.ts';
import { serveProject } from '../support/project-page.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../examples/a-lamp-and-a-window');
const OUTPUT = resolve(import.meta.dirname, '../output/lamp-and-window');
/** Where the robot stands, and its height. */
const ROBOT = { x: 0.8, z: -0.6, heightM: 0.42 * 1.4 } as const;
/** The lamp and the middle of the window from the center of the panorama (`tools/examples/lit-room.ts`). */
const LAMP = [1.3, 1.4, -1.2] as const;
const WINDOW = [-2, 0.65, -0.2] as const;
const EYE = { heightM: 2.2, fovYRad: 0.9 } as const;
/** From the front and above, near the robot. */
const BESIDE = { matrix: [0.89, 0, 0.456, 0, 0.225, 0.87, -0.439, 0, -0.397, 0.493, 0.774, 0, 0.3, 0.95, 0.4, 1] };
/** Where the visitor stands to take the panorama. */
const VISITOR: Place = [0.8, 1.5, 0.5];
/** Of the emulated phone. */
const PHONE = { fovYRad: 1.05, aspect: 4 / 3 } as const;
/** Where the lamp of the studio is moved to, from the middle of the room at 1.2 m. */
const MOVED: readonly [Direction, Direction] = [
  [-0.2, 0.42, 0.885],
  [0.901, 0.42, 0.107],
];
/** The window of the studio from where the visitor stands. */
const STUDIO_WINDOW: Direction = [-0.97, 0, -0.243];
const chromium = useBrowser();

let served: Awaited<ReturnType<typeof serveProject>>;
beforeAll(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  served = await serveProject(EXAMPLE);
});
afterAll(() => served.close());

/** Straight down at the robot. */
const ABOVE = { position: [ROBOT.x, EYE.heightM, ROBOT.z], quaternion: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] } as const;

async function keep(name: string, { data, width, height }: RgbaImage): Promise<void> {
  await sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png()
    .toFile(join(OUTPUT, `${name}.png`));
}

/** Looks straight down at the robot, and from the side. A phone uses the panorama file too, because the visitor skips the photos. */
async function see(device: DeviceName): Promise<{ layer: RgbaImage; errors: readonly string[]; controls: readonly string[] }> {
  const xr = await openXrPage(chromium.browser, served.url, {
    ...{ room: 'studio', device, views: 1, fovYRad: EYE.fovYRad, sizePx: [320, 320], display: false },
  });
  try {
    const controls = await xr.page.locator('#controls-body label').allTextContents();
    await xr.enter();
    if (device === 'phone') await barOf(xr).getByRole('button', { name: 'Skip' }).click();
    await xr.setPose(ABOVE);
    // The panorama is uploaded in parts between frames; before that there are no lamps.
    await untilShadow(xr);
    await xr.step(4);
    const layer = await xr.readLayer();
    await keep(`${device}-layer`, layer);
    await keep(`${device}-seen`, await xr.readComposite());
    await xr.setPose(BESIDE);
    await xr.step(2);
    await keep(`${device}-beside`, await xr.readComposite());
    return { layer, errors: xr.errors, controls };
  } finally {
    await xr.close();
  }
}

/** Steps until the layer differs where the shadow of the lamp falls, at most 10 s. */
async function untilShadow(xr: XrPage): Promise<void> {
  for (let i = 0; i < 100; i++) {
    await xr.step();
    const layer = await xr.readLayer();
    if (([1, 3] as const).some((channel) => Math.abs(meanAt(layer, inLampShadow, channel) - meanAt(layer, lit, channel)) > 1)) return;
    await xr.page.waitForTimeout(100);
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

const azimuthDeg = ([x, , z]: Direction): number => (Math.atan2(x, -z) * 180) / Math.PI;

/** Changes the view of the emulated device. */
async function setView(xr: XrPage, fovYRad: number, sizePx: readonly [number, number]): Promise<void> {
  await xr.page.evaluate(
    ([fov, size]) => {
      scrimEmulator?.current?.setFovY(fov);
      scrimEmulator?.current?.setSize(size);
    },
    [fovYRad, sizePx] as const,
  );
}

test('a phone takes the panorama, and takes it again after the lamp was moved: the shadow is where the lamp throws it', async () => {
  const options = { room: 'studio', device: 'phone', framesPerSecond: 4, sizePx: [200, 150], display: false } as const;
  const xr = await openXrPage(chromium.browser, served.url, options);
  try {
    const lamps: Direction[] = [];
    for (const direction of MOVED) lamps.push(await lampFrom(xr, VISITOR, direction));
    const targets = captureTargets(projectEye('none', PHONE.fovYRad, PHONE.aspect, 0.1, 100));
    const near = targets.filter((target) => [...lamps, STUDIO_WINDOW].some((place) => angleDeg(target, place) < 45));
    await xr.setPose(poseFrom(VISITOR, [0, 0, -1]));
    for (const [i, direction] of MOVED.entries()) {
      await xr.page.evaluate((at) => scrimEmulator?.current?.moveLight(at), direction);
      if (i === 0) await xr.enter();
      else {
        await setView(xr, PHONE.fovYRad, options.sizePx);
        await xr.page.getByRole('button', { name: 'Take the panorama again' }).click();
        await xr.step(1);
      }
      // A target may be ahead already.
      await barOf(xr).getByText('of 34 photos.').waitFor();
      await takePhotos(xr, VISITOR, near);
      await xr.page.getByRole('button', { name: 'Use these photos' }).click();
      await untilReady(xr);
      const taken = await storedPanorama(xr);
      await keep(`taken-${i}`, { width: taken.widthPx, height: taken.heightPx, data: taken.data });
      const found = findLampsAtOnce(taken, {
        method: 'solid-angle',
        lamps: 2,
        iterations: 1,
        intensities: 'ranks',
        clippedShare: 0.5,
      }).lamps;
      // There is a lamp where it is, and none where it was or will be.
      const errors = lamps.map((lamp) => Math.min(...found.map(({ towards }) => angleDeg(towards, lamp))));
      expect(errors.map((error) => (error < 2 ? 'lamp' : error > 10 ? 'none' : error))).toEqual(
        i === 0 ? ['lamp', 'none'] : ['none', 'lamp'],
      );
      // The brightest is the window, with its glow on the ceiling above it.
      expect(Math.abs(azimuthDeg(found[0]?.towards ?? [0, 0, 0]) - azimuthDeg(STUDIO_WINDOW))).toBeLessThan(5);
      await setView(xr, EYE.fovYRad, [200, 200]);
      await xr.setPose(ABOVE);
      // The panorama is uploaded in parts between frames.
      await eventually(async () => {
        await xr.step();
        const layer = await xr.readLayer();
        const dark = lamps.map((lamp) => meanAt(layer, shadowOf([...lamp], 0.25), 3));
        expect(dark[i]).toBeGreaterThan((dark[1 - i] ?? 0) + 8);
      });
      await setView(xr, EYE.fovYRad, [320, 320]);
      await xr.step(2);
      await keep(`moved-${i}-above`, await xr.readComposite());
      await xr.setPose(BESIDE);
      await xr.step(2);
      await keep(`moved-${i}-beside`, await xr.readComposite());
    }
    expect(xr.errors).toEqual([]);
  } finally {
    await xr.close();
  }
});
