import { mkdir, rm, writeFile } from 'node:fs/promises';
import { join, relative } from 'node:path';
import process from 'node:process';
import { build } from 'esbuild';
import { encode } from 'fast-png';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import type { FilmCamera } from '../../export/emulator/rooms/room-film.ts';
import { printSession } from '../../export/runtime/sessions/print-session.ts';
import type { Intrinsics, SessionFile } from '../../export/runtime/sessions/session-format.ts';
import type { ToolMain } from '../lib/tool.ts';
import type { StudioFrame } from './studio.page.ts';
import { cross, fromAxes, type Matrix, normalize, subtract, type Vector } from './vector.ts';

const FRAMES = 36;
const FRAME_RATE_HZ = 10;
const METERS_PER_UNIT = 0.001;
const COLOR = { widthPx: 480, heightPx: 360, intrinsics: { fxPx: 400, fyPx: 400, cxPx: 240, cyPx: 180 } } as const;
/** Camera of the depth images. Half the resolution of color, because phones measure depth at a lower resolution than color. */
const DEPTH = { widthPx: 240, heightPx: 180, intrinsics: { fxPx: 200, fyPx: 200, cxPx: 120, cyPx: 90 } } as const;
const NEAR_M = 0.1;
const FAR_M = 50;

/** Records the emulator’s studio in `examples/sessions/studio`: a short loop with exact depth. */
export const main: ToolMain = async (_args, { root }) => {
  const folder = join(root, 'examples', 'sessions', 'studio');
  const poses = Array.from({ length: FRAMES }, (_, i) => poseAt(i / FRAMES));
  const { frames, light, surfaces } = await filmInBrowser(root, poses);
  await rm(folder, { recursive: true, force: true });
  for (const kind of ['color', 'depth']) await mkdir(join(folder, kind), { recursive: true });
  let bytes = 0;
  for (const [i, frame] of frames.entries()) {
    const jpeg = Buffer.from(frame.jpeg, 'base64');
    const png = encode(
      { width: DEPTH.widthPx, height: DEPTH.heightPx, data: toUnits(frame.meters), depth: 16, channels: 1 },
      { zlib: { level: 9 } },
    );
    await writeFile(join(folder, colorPath(i)), jpeg);
    await writeFile(join(folder, depthPath(i)), png);
    bytes += jpeg.length + png.length;
  }
  const session: SessionFile = {
    format: 'scrim-session',
    version: 1,
    title: 'Studio',
    credit: 'Made by tools/sessions/make-studio.ts',
    licence: 'MIT',
    color: COLOR,
    depth: { ...DEPTH, metresPerUnit: METERS_PER_UNIT, kind: 'z' },
    frameRateHz: FRAME_RATE_HZ,
    light,
    surfaces,
    frames: poses.map((worldFromCamera, i) => ({ timeS: i / FRAME_RATE_HZ, color: colorPath(i), depth: depthPath(i), worldFromCamera })),
  };
  await writeFile(join(folder, 'session.json'), printSession(session));
  console.log(`${relative(process.cwd(), folder)}: ${frames.length} frames, ${(bytes / 1e6).toFixed(2)} MB`);
  return 0;
};

function colorPath(i: number): string {
  return `color/${String(i).padStart(3, '0')}.jpg`;
}

function depthPath(i: number): string {
  return `depth/${String(i).padStart(3, '0')}.png`;
}

/** Camera pose on a small loop, like a person with a phone; `turn` in [0, 1). */
function poseAt(turn: number): Matrix {
  const angle = 2 * Math.PI * turn;
  const eye: Vector = [0.8 - 0.3 * Math.cos(angle), 1.42 + 0.07 * Math.sin(angle + 0.6), 1.6 + 0.12 * Math.sin(angle)];
  const target: Vector = [-0.22 + 0.14 * Math.cos(angle + 0.9), 0.62 + 0.05 * Math.sin(2 * angle), -0.95];
  const z = normalize(subtract(eye, target));
  const x = normalize(cross([0.012 * Math.sin(angle), 1, 0], z));
  return fromAxes(x, cross(z, x), z, eye);
}

async function filmInBrowser(root: string, poses: readonly Matrix[]) {
  const found = await findChromium({ pinnedOnly: true });
  if (!found) throw new Error('The pinned Chromium (@sparticuz/chromium) is missing: the session is only ever made with it.');
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage();
    await page.addScriptTag({ content: await bundlePage(root) });
    const camera: FilmCamera = {
      ...COLOR,
      depthWidthPx: DEPTH.widthPx,
      depthHeightPx: DEPTH.heightPx,
      clipFromView: projection(COLOR),
      jpegQuality: 0.82,
      oversampling: 2,
    };
    const { light, surfaces } = await page.evaluate(() => globalThis.studio.survey());
    const frames: readonly StudioFrame[] = await page.evaluate(([c, p]) => globalThis.studio.film(c, p), [camera, poses] as const);
    return { frames, light, surfaces };
  } finally {
    await browser.close();
  }
}

async function bundlePage(root: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [join(root, 'tools', 'sessions', 'studio.page.ts')],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'studio',
    target: 'chrome108',
  });
  return outputFiles[0]?.text ?? '';
}

/** Projection matrix of a pinhole camera; see `docs/SESSION-FORMAT.md`. */
function projection({
  widthPx,
  heightPx,
  intrinsics,
}: {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly intrinsics: Intrinsics;
}): Matrix {
  const { fxPx, fyPx, cxPx, cyPx } = intrinsics;
  const range = NEAR_M - FAR_M;
  return [
    (2 * fxPx) / widthPx,
    0,
    0,
    0,
    0,
    (2 * fyPx) / heightPx,
    0,
    0,
    1 - (2 * cxPx) / widthPx,
    (2 * cyPx) / heightPx - 1,
    (NEAR_M + FAR_M) / range,
    -1,
    0,
    0,
    (2 * NEAR_M * FAR_M) / range,
    0,
  ];
}

function toUnits(base64: string): Uint16Array {
  const bytes = Buffer.from(base64, 'base64');
  const meters = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
  return Uint16Array.from(meters, (m) => Math.round(m / METERS_PER_UNIT));
}

declare global {
  /** The exports of `studio.page.ts`, as a global of the page in the browser. */
  var studio: typeof import('./studio.page.ts');
}
