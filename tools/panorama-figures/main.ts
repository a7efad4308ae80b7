import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { decode } from 'fast-png';
import sharp, { type OverlayOptions } from 'sharp';
import { type FoundLamps, type LampStep, NO_LAMPS } from '../../nodes/kit/panorama/found-lamps.ts';
import { findByPaper } from '../../nodes/kit/panorama/paper-method.ts';
import { type PanoramaPixels, runWhole } from '../../nodes/kit/panorama/pixels.ts';
import { makeLitRoomShot } from '../examples/lit-room.ts';
import type { ToolMain } from '../lib/tool.ts';
import { drawPageFigures } from './page-figures.ts';

const OUT = 'docs/images/panorama-refused.webp';
/** Exposures of the example room, in stops: the one at which the walls are nearly white too, and the one at which they are gray. */
const SHOTS = [1, 0] as const;
const COLUMN = { widthPx: 512, imagePx: 256, chartPx: 128, gapPx: 16 } as const;

/**
 * `npm run panorama-figures` draws the panoramas that Lights from panorama refuses (figures 6 and 7 of the ARPAS paper) from the room of the
 * examples, with their histograms, for `docs/PANORAMAS.md`, and prints what is measured in them. It also composes the figures of the example
 * “A lamp and a window” from the pictures of its test.
 */
export const main: ToolMain = async (_, { root }) => {
  const parts: OverlayOptions[] = [];
  for (const [i, stops] of SHOTS.entries()) {
    const png = makeLitRoomShot(stops);
    const { none, step } = refusal(png);
    const { max, mean, abovePart } = step;
    const measured = `brightest ${max}, mean ${mean.toFixed(1)}, ratio ${(max / mean).toFixed(2)}, above 93 %: ${(100 * abovePart).toFixed(2)} %`;
    console.log(`${stops} stops: ${measured}: ${NO_LAMPS[none]}.`);
    const left = i * (COLUMN.widthPx + COLUMN.gapPx);
    parts.push({ input: await sharp(png).resize({ width: COLUMN.widthPx, kernel: 'nearest' }).png().toBuffer(), left, top: 0 });
    parts.push({ input: Buffer.from(histogramOf(step)), left, top: COLUMN.imagePx + COLUMN.gapPx });
  }
  const [width, height] = [2 * COLUMN.widthPx + COLUMN.gapPx, COLUMN.imagePx + COLUMN.gapPx + COLUMN.chartPx];
  const sheet = sharp({ create: { width, height, channels: 3, background: '#ffffff' } }).composite(parts);
  await writeFile(join(root, OUT), await sheet.webp({ quality: 85 }).toBuffer());
  await drawPageFigures(root);
  return 0;
};

/** Why the method of the paper finds nothing in a photo, and what it has measured. */
function refusal(png: Uint8Array): { readonly none: NonNullable<FoundLamps['none']>; readonly step: LampStep } {
  const { width, height, data } = decode(png);
  const pixels: PanoramaPixels = { widthPx: width, heightPx: height, channels: 3, data: data as Uint8Array };
  const { none, steps } = runWhole(findByPaper(pixels, { lamps: 3, iterations: 1, intensities: 'ranks' }));
  const [step] = steps;
  if (none === null || !step) throw new Error('Lamps were found: expose the room more.');
  return { none, step };
}

/** The histogram by the square root of its counts, with the threshold. */
function histogramOf({ histogram, threshold }: LampStep): string {
  const { widthPx, chartPx } = COLUMN;
  const most = Math.sqrt(Math.max(...histogram));
  const bars = [...histogram].map((count, level) => {
    const high = (Math.sqrt(count) / most) * chartPx;
    return `<rect x="${level * 2}" y="${(chartPx - high).toFixed(1)}" width="2" height="${high.toFixed(1)}" fill="#666"/>`;
  });
  const line = `<line x1="${threshold * 2}" x2="${threshold * 2}" y1="0" y2="${chartPx}" stroke="#d33" stroke-width="2"/>`;
  const frame = `<rect width="${widthPx}" height="${chartPx}" fill="#f4f4f4"/>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${widthPx}" height="${chartPx}">${frame}${bars.join('')}${line}</svg>`;
}
