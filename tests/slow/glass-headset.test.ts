import { mkdirSync, writeFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import { glassBallBeforeBox } from '../support/glass-project.ts';
import { encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { eventually } from '../support/patience.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { serveProjectText } from '../support/project-page.ts';
import { openXrPage, readCapture } from '../xr/xr-page.ts';

const chromium = useBrowser();
const livingRoom = await readCapture('living_room');

/** For a person to look at. */
function keep(name: string, image: RgbaImage): void {
  mkdirSync('tests/output/glass', { recursive: true });
  writeFileSync(`tests/output/glass/${name}.png`, encodeImage(image));
}

/** Red pixels in a part of a picture. */
function reds(image: RgbaImage, fromX: number, toX: number): number {
  let count = 0;
  for (let y = 0; y < image.height; y++) {
    for (let x = fromX; x < toX; x++) {
      const [r, g, b, a] = pixelAt(image, x, y);
      if (a > 100 && r > g + 50 && r > b + 50) count++;
    }
  }
  return count;
}

test('both eyes of a headset see a box through a ball of glass before it', async () => {
  const served = await serveProjectText(
    glassBallBeforeBox({ ballM: 0.4, ballAt: [-1, 1.5, 0], boxM: 0.2, boxAt: [-1.8, 1.5, 0], isInRoom: true }),
    {},
  );
  const xr = await openXrPage(
    chromium.browser,
    served.url,
    { room: livingRoom, device: 'headset', extra: ['camera-access'], display: false },
    { width: 640, height: 480 },
  );
  await xr.enter();
  await xr.setPose({ position: [0, 1.5, 0], quaternion: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
  await xr.step(3);
  const layer = await xr.readLayer();
  keep('headset-layer', layer);
  keep('headset', await xr.readComposite());
  const half = layer.width / 2;
  const [left, right] = [reds(layer, 0, half), reds(layer, half, layer.width)];
  expect(left).toBeGreaterThan(300);
  expect(Math.abs(right - left)).toBeLessThan(left / 4);
  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
});

const CENTER = [0, 1.4, 0] as const;

/** The walls of a room, each of another color, by the side of the viewer that they are on. */
const WALLS = {
  right: { towards: [1, 0, 0], albedo: [0.9, 0, 0] },
  left: { towards: [-1, 0, 0], albedo: [0, 0.9, 0] },
  above: { towards: [0, 1, 0], albedo: [0, 0, 0.9] },
  below: { towards: [0, -1, 0], albedo: [0.9, 0.9, 0] },
  behind: { towards: [0, 0, 1], albedo: [0, 0.9, 0.9] },
  before: { towards: [0, 0, -1], albedo: [0.9, 0, 0.9] },
} as const;

const ROOM: NonNullable<EmulatorOptions['room']> = {
  boxes: Object.values(WALLS).map(({ towards, albedo }) => ({
    label: 'wall',
    centerWorld: [2 * towards[0], CENTER[1] + 2 * towards[1], 2 * towards[2]],
    sizeM: [towards[0] === 0 ? 3.8 : 0.2, towards[1] === 0 ? 3.8 : 0.2, towards[2] === 0 ? 3.8 : 0.2],
    albedo,
  })),
};

/** A ball of dense black glass a meter before the viewer, so that it shows only what it mirrors, in the light that is estimated. */
const IN_ESTIMATE: ProjectText = {
  title: 'Glass in the light of the room',
  nodes: {
    'ball-a1': ['objects/primitive', { shape: 'sphere', sizeM: [0.5, 0.5, 0.5] }],
    'place-a1': ['objects/transform', { positionM: [0, CENTER[1], -0.2] }],
    'glass-a1': ['technique/glass', { ior: 2.5, mirror: 2, shine: 0, haze: 0, dispersion: 0, tint: [0, 0, 0, 1] }],
    'clear-a1': 'objects/apply-technique',
    'estimate-b2': ['world/light-estimate', { castShadow: false, guessFromCamera: true }],
    'scene-c3': ['layer/scene', { shadows: false }],
    'screen-d4': 'output/screen',
  },
  wires: [
    'ball-a1.objects -> place-a1.objects',
    'place-a1.objects -> clear-a1.objects',
    'glass-a1.technique -> clear-a1.technique',
    'clear-a1.objects -> scene-c3.objects',
    'estimate-b2.lights -> scene-c3.lights',
    'scene-c3.layer -> screen-d4.layer',
  ],
};

/** Checks what the ball mirrors from each side of the room. The light may come frames later: that of the camera is read asynchronously. */
async function checkMirrored(options: EmulatorOptions, name: string, check: (mirrored: ReturnType<typeof mirroredIn>) => void) {
  const served = await serveProjectText(IN_ESTIMATE, {});
  const xr = await openXrPage(chromium.browser, served.url, { room: ROOM, device: 'phone', display: false, ...options });
  await xr.enter();
  await xr.setPose({ position: [0, CENTER[1], 0.8], quaternion: [0, 0, 0, 1] });
  await eventually(async () => {
    await xr.step(6);
    const layer = await xr.readLayer();
    keep(`${name}-layer`, layer);
    check(mirroredIn(layer));
  });
  keep(name, await xr.readComposite());
  expect(xr.errors).toEqual([]);
  await xr.close();
  await served.close();
}

function mirroredIn(layer: RgbaImage) {
  const middle = [Math.floor(layer.width / 2), Math.floor(layer.height / 2)] as const;
  let radiusPx = 0;
  while (pixelAt(layer, middle[0] + radiusPx, middle[1])[3] > 0) radiusPx++;
  // There, the ball's normal is at 45° to the eye: the law of reflection.
  const off = Math.round(radiusPx * Math.SQRT1_2);
  const at = (x: number, y: number): readonly number[] => pixelAt(layer, middle[0] + x, middle[1] + y).slice(0, 3);
  return { radiusPx, seen: { right: at(off, 0), left: at(-off, 0), above: at(0, -off), below: at(0, off), behind: at(0, 0) } };
}

test('glass on a phone that measures the light mirrors each wall of the room on the side where the wall is', () =>
  checkMirrored({}, 'mirrors-measured', ({ radiusPx, seen }) => {
    expect(radiusPx).toBeGreaterThan(30);
    for (const [side, rgb] of Object.entries(seen)) {
      const { albedo } = WALLS[side as keyof typeof seen];
      const most = Math.max(...rgb);
      expect(most).toBeGreaterThan(30);
      expect([side, rgb.map((value) => value > 0.5 * most)]).toEqual([side, albedo.map((value) => value > 0)]);
    }
  }));

test('glass on a phone that measures no light mirrors the color that its camera sees', () =>
  checkMirrored({ refuse: ['light-estimation'], extra: ['camera-access'] }, 'mirrors-camera', ({ seen }) => {
    // The wall before it is magenta.
    for (const [side, [r = 0, g = 0, b = 0]] of Object.entries(seen)) {
      expect([side, r > 2 * g + 10, b > 2 * g + 10]).toEqual([side, true, true]);
    }
  }));
