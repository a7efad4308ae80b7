import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import type { LinkedPass, LinkOptions } from '../../export/glsl/link/linked-pass.ts';
import { readImageShader } from '../../export/glsl/read-definition.ts';
import type { Result } from '../../nodes/kit/diagnostics.ts';
import type { PageModule } from '../support/browser.ts';
import { fromGl, type RgbaImage } from '../support/image.ts';
import type { Drawing, DrawJob, Picture as PageImage } from './glsl.page.ts';

export const PAGE = 'tests/browser/glsl.page.ts';

/** What a reader or linker made; throws with its diagnostics where it made nothing. */
export function made<T>({ output, diagnostics }: Result<T>): T {
  if (output === null) throw new Error(JSON.stringify(diagnostics, null, 2));
  return output;
}

export function linkText(
  source: string,
  options: Partial<LinkOptions> = {},
  file = 'test.fs',
  vertex: string | null = null,
): readonly LinkedPass[] {
  return made(linkIsf(made(readImageShader(source, file, vertex)), { node: 'test', ...options }));
}

/** Top row first, as images are stored, to bottom row first, as textures are. */
export function toPage(picture: RgbaImage): PageImage {
  const { width, height, data } = fromGl(picture.width, picture.height, picture.data);
  return { width, height, rgba: Buffer.from(data).toString('base64') };
}

/** A image from a color per pixel, premultiplied, each channel from 0 to 255; (0, 0) is the top left. */
export function paint(
  width: number,
  height: number,
  color: (x: number, y: number) => readonly [number, number, number, number],
): RgbaImage {
  const data = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data.set(color(x, y), (y * width + x) * 4);
  return { width, height, data };
}

/** Draws, and fails on anything the driver complains about. */
export async function drawPicture(page: PageModule, job: DrawJob): Promise<RgbaImage> {
  const drawing = await drawAny(page, job);
  return fromGl(job.width, job.height, Buffer.from(drawing.rgba, 'base64'));
}

/** Red channel of a float output, top row first. */
export async function drawFloats(page: PageModule, job: DrawJob): Promise<number[]> {
  const { floats } = await drawAny(page, job);
  const rows: number[][] = [];
  for (let y = 0; y < job.height; y++) {
    rows.unshift(Array.from({ length: job.width }, (_, x) => floats[(y * job.width + x) * 4] ?? Number.NaN));
  }
  return rows.flat();
}

async function drawAny(page: PageModule, job: DrawJob): Promise<Drawing> {
  const drawing = await page.call<Drawing>('draw', job);
  const logs = drawing.logs.filter((log) => log !== '');
  if (logs.length > 0 || drawing.glError !== 0) throw new Error(`GL error ${drawing.glError}: ${logs.join('\n')}`);
  return drawing;
}
