import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { LinkedPass } from '../../export/glsl/link/linked-pass.ts';
import type { PageModule } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { drawPicture, made, paint, toPage } from './glsl-kit.ts';

const FOLDER = 'shader-library';

/** Text of every filter, operator and generator by its path in the library, such as `filters/sepia.fs`. */
export const SHADERS: Readonly<Record<string, string>> = Object.fromEntries(
  ['filters', 'operators', 'generators'].flatMap((kind) =>
    readdirSync(join(FOLDER, kind))
      .filter((file) => file.endsWith('.fs'))
      .sort()
      .map((file) => [`${kind}/${file}`, readFileSync(join(FOLDER, kind, file), 'utf8')]),
  ),
);

export type Params = Readonly<Record<string, number | readonly number[]>>;

interface LibraryShader {
  readonly defaults: Params;
  readonly passes: readonly LinkedPass[];
}

/** Linked shaders, by their path: tests draw with one several times. */
const linked = new Map<string, LibraryShader>();

function linkedOf(file: string): LibraryShader {
  const known = linked.get(file);
  if (known) return known;
  const shader = made(readIsf(SHADERS[file] ?? '', file));
  const defaults = Object.fromEntries(shader.inputs.map((input) => [input.name, input.default]));
  const found = { defaults, passes: made(linkIsf(shader, { node: 'test' })) };
  linked.set(file, found);
  return found;
}

/** Draws a library shader with its defaults, except for `params`, in the size of the first picture. */
export async function applyShader(
  page: PageModule,
  file: string,
  pictures: Readonly<Record<string, RgbaImage>>,
  params: Params = {},
  size: Pick<RgbaImage, 'width' | 'height'> | undefined = Object.values(pictures)[0],
): Promise<RgbaImage> {
  const { defaults, passes } = linkedOf(file);
  if (size === undefined) throw new Error('A filter needs a picture.');
  return drawPicture(page, {
    width: size.width,
    height: size.height,
    passes,
    pictures: Object.fromEntries(Object.entries(pictures).map(([name, picture]) => [name, toPage(picture)])),
    params: { ...defaults, ...params },
  });
}

/** The noise of a camera: whole numbers from −3 to 3 without a pattern, others for each seed. */
export const noiseOf = (seed: number) => (x: number, y: number) =>
  Math.floor(((Math.sin(x * 12.9898 + y * 78.233 + seed) * 43758.5453) % 1) * 3.5);

/** One of the images in `tests/browser/expected/`; the scripts beside them say who made them. */
export async function expectedImage(name: string): Promise<RgbaImage> {
  return decodeImage(await readFile(`tests/browser/expected/${name}.png`));
}

/** The part of a photograph of the shared data that `expected/filters.py` uses. */
export async function photograph(path: string): Promise<RgbaImage> {
  const whole = decodeImage(await readFile(path));
  return paint(256, 256, (x, y) => pixelAt(whole, x + 128, y));
}

/** The pixels that it keeps of the result. */
export function samplesOf(picture: RgbaImage): RgbaImage {
  const every = 8;
  const [left, top] = [5, 7];
  const count = (size: number, first: number) => Math.ceil((size - first) / every);
  return paint(count(picture.width, left), count(picture.height, top), (x, y) => pixelAt(picture, left + x * every, top + y * every));
}
