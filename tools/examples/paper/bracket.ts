import { bundleScript } from '../../../app/services/bundle-script.ts';
import { findChromium } from '../../../app/services/chromium.ts';
import { startBrowser } from '../../../app/services/start-browser.ts';
import type { FilmCamera } from '../../../export/emulator/rooms/room-film.ts';
import { cross, fromAxes, normalize, subtract, type Vector } from '../../sessions/vector.ts';
import { BRACKET } from './bracket-stops.ts';

const EYE: Vector = [0.95, 1.42, 0.75];
const TARGET: Vector = [-2.2, 0.98, -0.75];
const [WIDTH_PX, HEIGHT_PX] = [960, 720];
const TAN_HALF_HEIGHT = 0.5;
const [NEAR_M, FAR_M] = [0.1, 50];

/**
 * Two photographs of the studio toward its window, as JPEG: one with the exposure of the corners, one with that of the window. The pinned
 * browser draws them, always with the same bytes.
 */
export async function makeBracket(root: string): Promise<Readonly<Record<keyof typeof BRACKET, Uint8Array>>> {
  const found = await findChromium({ pinnedOnly: true });
  if (!found) throw new Error('The pinned Chromium is missing: run `npm ci` on Linux x64.');
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage();
    await page.addScriptTag({ content: await bundleScript(root, 'tools/examples/paper/bracket.page.ts', 'bracket') });
    const shots = (await page.evaluate(
      `bracket.shootBracket(${JSON.stringify(camera())}, ${JSON.stringify(pose())}, ${JSON.stringify([BRACKET.long, BRACKET.short])})`,
    )) as number[][];
    return { long: Uint8Array.from(shots[0] ?? []), short: Uint8Array.from(shots[1] ?? []) };
  } finally {
    await browser.close();
  }
}

function pose(): readonly number[] {
  const z = normalize(subtract(EYE, TARGET));
  const x = normalize(cross([0, 1, 0], z));
  return fromAxes(x, cross(z, x), z, EYE);
}

function camera(): FilmCamera {
  const up = 1 / TAN_HALF_HEIGHT;
  const range = NEAR_M - FAR_M;
  return {
    widthPx: WIDTH_PX,
    heightPx: HEIGHT_PX,
    depthWidthPx: 4,
    depthHeightPx: 3,
    clipFromView: [
      (up * HEIGHT_PX) / WIDTH_PX,
      0,
      0,
      0,
      0,
      up,
      0,
      0,
      0,
      0,
      (NEAR_M + FAR_M) / range,
      -1,
      0,
      0,
      (2 * NEAR_M * FAR_M) / range,
      0,
    ],
    jpegQuality: 0.88,
    oversampling: 2,
  };
}
