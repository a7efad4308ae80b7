import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import pixelmatch from 'pixelmatch';
import { decodeImage, encodeImage, type RgbaImage } from './image.ts';
import { currentTest, OUTPUT_FOLDER, refreshCommand, TESTS_FOLDER, updatesGoldens } from './this-test.ts';

export interface PixelOptions {
  /** Largest difference in a channel that counts as equal, in 8-bit steps. Default: 0. */
  readonly tolerance?: number;
  /** Number of pixels that may differ by more. Default: 0. */
  readonly pixels?: number;
}

/**
 * Compares with the golden `tests/goldens/PROJECT/NAME.png`. `UPDATE_GOLDENS=1` writes it instead. A missing golden fails the test,
 * so that none is created by accident. Only for images of the pinned Chromium.
 */
export async function expectPixels(name: string, actual: RgbaImage, options: PixelOptions = {}): Promise<void> {
  const path = join(TESTS_FOLDER, 'goldens', currentTest().project, `${name}.png`);
  if (updatesGoldens()) {
    await write(path, actual);
    return;
  }
  const bytes = await readFile(path).catch(() => null);
  if (bytes === null) {
    const kept = await write(outputPath(name, 'actual'), actual);
    throw new Error(`There is no golden picture ${shown(path)} yet.\nactual:   ${kept}\nIf it looks right: ${refreshCommand()}`);
  }
  await compare(name, actual, decodeImage(bytes), options, `\nIf the new picture is right: ${refreshCommand()}`);
}

/** Compares two images of the same test, such as those of the preview and the exported page. */
export async function expectSamePixels(name: string, actual: RgbaImage, expected: RgbaImage, options: PixelOptions = {}): Promise<void> {
  await compare(name, actual, expected, options, '');
}

/** Number of pixels that differ by more than `tolerance` in a channel, and the largest difference. */
export function countDifferent(a: RgbaImage, b: RgbaImage, tolerance = 0): { readonly pixels: number; readonly largest: number } {
  let pixels = 0;
  let largest = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    let difference = 0;
    for (let channel = i; channel < i + 4; channel++) {
      difference = Math.max(difference, Math.abs((a.data[channel] ?? 0) - (b.data[channel] ?? 0)));
    }
    if (difference > tolerance) pixels++;
    largest = Math.max(largest, difference);
  }
  return { pixels, largest };
}

/** Number of different colors, without alpha. Most images of a scene have many. */
export function countColors({ data }: RgbaImage): number {
  const seen = new Set<number>();
  for (let i = 0; i < data.length; i += 4) seen.add(((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0));
  return seen.size;
}

async function compare(name: string, actual: RgbaImage, expected: RgbaImage, options: PixelOptions, advice: string): Promise<void> {
  const { tolerance = 0, pixels = 0 } = options;
  const sameSize = actual.width === expected.width && actual.height === expected.height;
  const different = sameSize ? countDifferent(actual, expected, tolerance) : null;
  if (different !== null && different.pixels <= pixels) return;
  const lines = [
    different === null
      ? `${name}: ${actual.width}×${actual.height} instead of ${expected.width}×${expected.height} pixels.`
      : `${name}: ${different.pixels} pixels differ by more than ${tolerance} (at most ${different.largest}); ${pixels} may.`,
    `expected: ${await write(outputPath(name, 'expected'), expected)}`,
    `actual:   ${await write(outputPath(name, 'actual'), actual)}`,
  ];
  if (different !== null) lines.push(`diff:     ${await write(outputPath(name, 'diff'), drawDifference(actual, expected))}`);
  throw new Error(lines.join('\n') + advice);
}

/** An image of all differing pixels in red over the faded original. */
function drawDifference(actual: RgbaImage, expected: RgbaImage): RgbaImage {
  const { width, height } = actual;
  const data = new Uint8Array(width * height * 4);
  pixelmatch(actual.data, expected.data, data, width, height, { threshold: 0, includeAA: true });
  return { width, height, data };
}

function outputPath(name: string, role: 'expected' | 'actual' | 'diff'): string {
  return join(OUTPUT_FOLDER, 'pixels', `${name}.${role}.png`);
}

async function write(path: string, picture: RgbaImage): Promise<string> {
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, encodeImage(picture));
  return shown(path);
}

function shown(path: string): string {
  return relative(process.cwd(), path);
}
