import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { readPfm } from '../../export/captures/depth/read-depth.ts';
import { projectText } from './project-kit.ts';
import { succeed } from './scrim.ts';

/** A photograph of `scrim capture`: RGBA with straight alpha, and meters. */
export interface Acquired {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly pixels: Uint8Array;
  readonly meters: Float32Array;
}

/** Takes photographs of a project with `scrim capture`, and reads them. */
export async function acquire(project: string, out: string, ...options: readonly string[]): Promise<readonly Acquired[]> {
  await succeed('capture', project, '--out', out, ...options);
  const { frames } = JSON.parse(await readFile(join(out, 'transforms.json'), 'utf8')) as {
    frames: { file_path: string; depth_file_path: string }[];
  };
  return Promise.all(
    frames.map(async (frame) => {
      const { width, height, data } = decode(await readFile(join(out, frame.file_path)));
      const depth = readPfm(await readFile(join(out, frame.depth_file_path)), frame.depth_file_path);
      return { widthPx: width, heightPx: height, pixels: Uint8Array.from(data), meters: depth.values };
    }),
  );
}

export interface Likeness {
  /** Over red, green and blue of the pixels that both show fully. */
  readonly psnrDb: number;
  /** The part of the opaque pixels of the first that the second shows, too. */
  readonly covered: number;
  /** The median and the 95th percentile of the relative difference of depth. */
  readonly depthMedian: number;
  readonly depth95: number;
}

export function likenessOf(truth: Acquired, shown: Acquired): Likeness {
  let square = 0;
  let both = 0;
  let opaque = 0;
  const differences: number[] = [];
  truth.meters.forEach((meters, i) => {
    if (truth.pixels[4 * i + 3] !== 255) return;
    opaque++;
    if (shown.pixels[4 * i + 3] !== 255) return;
    both++;
    for (let c = 4 * i; c < 4 * i + 3; c++) square += ((truth.pixels[c] ?? 0) - (shown.pixels[c] ?? 0)) ** 2;
    differences.push(Math.abs((shown.meters[i] ?? 0) / meters - 1));
  });
  differences.sort((a, b) => a - b);
  const part = (share: number) => differences[Math.floor(share * differences.length)] ?? Number.NaN;
  return { psnrDb: 10 * Math.log10((255 * 255 * 3 * both) / square), covered: both / opaque, depthMedian: part(0.5), depth95: part(0.95) };
}

/** A project that shows a captured place alone. */
export function placeText(path: string, params: Readonly<Record<string, unknown>> = {}): string {
  return projectText({
    nodes: { 'place-a1': ['source/capture', { file: 'place', ...params }], 'screen-a1': 'output/screen' },
    wires: ['place-a1.layer -> screen-a1.layer'],
    assets: { place: { path, kind: 'capture' } },
  });
}
