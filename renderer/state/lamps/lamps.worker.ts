import { readRadianceHeader } from '../../../export/runtime/scenes/environments/radiance-header.ts';
import { readRadiance } from '../../../export/runtime/scenes/environments/read-radiance.ts';
import { findLamps, searchWhole } from '../../../nodes/kit/panorama/find-lamps.ts';
import type { FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import { grayImageOf } from '../../../nodes/kit/panorama/gray-image.ts';
import { halvesWithAlpha } from '../../../nodes/kit/panorama/half-floats.ts';
import { mergeExposures } from '../../../nodes/kit/panorama/merge-exposures.ts';
import { createRowReader, isDisplayReferred, type PanoramaPixels, runWhole } from '../../../nodes/kit/panorama/pixels.ts';
import type { LampAnswer, LampRequest, LampStage } from './messages.ts';

/** Worker that decodes and searches a panorama for the inspector, and draws the steps of the search. */
const scope = self as unknown as {
  onmessage: ((event: MessageEvent<LampRequest>) => void) | null;
  postMessage(answer: LampAnswer, transfer?: Transferable[]): void;
};

/** Maximum width of the images for the inspector. Larger images are reduced. */
const SHOWN_WIDTH_PX = 1024;

scope.onmessage = async ({ data: { files, stopsApart, options } }) => {
  try {
    const pixels = await merged(files, stopsApart);
    const found = searchWhole(findLamps(pixels, options), pixels, (part) => scope.postMessage({ kind: 'part', part }));
    const stages = await drawStages(pixels, found);
    scope.postMessage(
      { kind: 'found', found, stages },
      stages.map(({ image }) => image),
    );
  } catch (error) {
    scope.postMessage({ kind: 'failed', reason: error instanceof Error ? error.message : String(error) });
  }
};

/** One panorama as it is, or shots merged as the page merges them. */
async function merged(files: readonly ArrayBuffer[], stopsApart: number): Promise<PanoramaPixels> {
  const shots: PanoramaPixels[] = [];
  for (const file of files) shots.push(await decode(file));
  const [only] = shots;
  if (only && shots.length === 1) return only;
  const { widthPx, heightPx, data } = runWhole(mergeExposures(shots, stopsApart));
  return { widthPx, heightPx, channels: 4, data: halvesWithAlpha(data) };
}

async function decode(bytes: ArrayBuffer): Promise<PanoramaPixels> {
  const header = readRadianceHeader(bytes);
  if (header) return readRadiance.floats(bytes, header);
  const bitmap = await createImageBitmap(new Blob([bytes]), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' }).catch(() => {
    throw new Error('it is no picture');
  });
  const { width: widthPx, height: heightPx } = bitmap;
  const context = new OffscreenCanvas(widthPx, heightPx).getContext('2d');
  if (!context) throw new Error('the browser gives no canvas to read it');
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { widthPx, heightPx, channels: 4, data: context.getImageData(0, 0, widthPx, heightPx).data };
}

async function drawStages(pixels: PanoramaPixels, { widthPx, heightPx, steps }: FoundLamps): Promise<LampStage[]> {
  const stages: LampStage[] = [{ kind: 'picture', iteration: 0, image: await draw(pixels.widthPx, pixels.heightPx, imageOf(pixels)) }];
  if (steps.length === 0) return stages;
  const { gray } = runWhole(grayImageOf(pixels));
  for (const [iteration, { bright, smooth }] of steps.entries()) {
    const stage = async (kind: LampStage['kind'], values: Uint8Array, factor: number): Promise<LampStage> => ({
      kind,
      iteration,
      image: await draw(widthPx, heightPx, grayPixels(values, factor)),
    });
    stages.push(await stage('gray', gray, 1), await stage('threshold', bright, 255), await stage('median', smooth, 255));
  }
  return stages;
}

function grayPixels(values: Uint8Array, factor: number): Uint8ClampedArray<ArrayBuffer> {
  const rgba = new Uint8ClampedArray(values.length * 4);
  for (let i = 0; i < values.length; i++) rgba.fill((values[i] ?? 0) * factor, i * 4, i * 4 + 3).fill(255, i * 4 + 3, i * 4 + 4);
  return rgba;
}

/**
 * Converts a panorama to pixels for the screen. Radiance is exposed so that its mean becomes a middle gray; bright lamps count little in
 * the mean.
 */
function imageOf(pixels: PanoramaPixels): Uint8ClampedArray<ArrayBuffer> {
  const { widthPx, heightPx } = pixels;
  const linear = new Float32Array(widthPx * heightPx * 3);
  const rows = createRowReader(pixels);
  for (let y = 0; y < heightPx; y++) rows.read(y, linear.subarray(y * widthPx * 3, (y + 1) * widthPx * 3));
  let sum = 0;
  // Lamps would darken everything else.
  for (const one of linear) sum += Math.min(one, 4);
  const exposure = isDisplayReferred(pixels) || sum === 0 ? 1 : (0.3 * linear.length) / sum;
  const rgba = new Uint8ClampedArray(widthPx * heightPx * 4);
  for (let i = 0, from = 0; i < rgba.length; i += 4) {
    for (let c = 0; c < 3; c++) rgba[i + c] = 255 * Math.min(1, (linear[from++] ?? 0) * exposure) ** (1 / 2.2);
    rgba[i + 3] = 255;
  }
  return rgba;
}

async function draw(widthPx: number, heightPx: number, rgba: Uint8ClampedArray<ArrayBuffer>): Promise<ImageBitmap> {
  const image = new ImageData(rgba, widthPx, heightPx);
  if (widthPx <= SHOWN_WIDTH_PX) return createImageBitmap(image);
  const scale = SHOWN_WIDTH_PX / widthPx;
  return createImageBitmap(image, { resizeWidth: SHOWN_WIDTH_PX, resizeHeight: Math.max(1, Math.round(heightPx * scale)) });
}
