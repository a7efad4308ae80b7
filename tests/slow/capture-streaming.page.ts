import { compareImages } from '../../export/captures/evaluate/image-quality.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { type LoadedCapture, loadCapture } from '../../export/runtime/assets/capture/load-capture.ts';
import { createBrowserClock } from '../../export/runtime/clock.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { readCapture } from '../../nodes/kit/capture.ts';
import { createGl } from '../browser/scenes-kit.ts';
import { photoPixels } from '../support/photo-pixels.page.ts';
import type { LoadingCurve } from '../support/quality-plot.ts';
import { draw } from './capture.page.ts';

export interface Streamed {
  /**
   * Files in the order in which they were requested, with the bytes that had arrived before, the PSNR of the image against the final one, and
   * the seconds since the first request, without those in which the test draws and compares.
   */
  readonly steps: readonly {
    readonly file: string;
    readonly bytesBefore: number;
    readonly psnrDb: number | null;
    readonly timeS: number;
  }[];
  readonly totalBytes: number;
  /** Whether the final image is that of a capture that was loaded whole, byte for byte. */
  readonly equalsWhole: boolean;
  /** Whether a capture that is disposed while it loads leaves GL objects: between two files, or between two parts of work of the GPU. */
  readonly leaks: boolean;
  readonly error: number;
}

const { delay } = createBrowserClock();

/** Loads a capture of a page as the page does, and draws it from the camera of a view before each file that it requests. */
export async function stream(baseUrl: string, file: string, view: number): Promise<Streamed> {
  const source = createFetchAssetSource(new URL(baseUrl, location.href).href, (...args: Parameters<typeof fetch>) => fetch(...args));
  const bytes = await source.load(file);
  const document = readCapture(new TextDecoder().decode(bytes));
  const target = document.views[view];
  if (!target) throw new Error(`There is no view ${view}.`);
  const gl = createGl(target.widthPx, target.heightPx);
  const objects = createGlObjects(gl);
  const { coarseMesh: _, ...withoutCoarse } = document;
  const views = document.views.map(({ reducedFile: _, ...kept }) => kept);
  const plain = new TextEncoder().encode(JSON.stringify({ ...withoutCoarse, views })).buffer;
  const whole = await loadCapture(objects, plain, file, source.load, false);
  const truth = draw(gl, whole, 'lumigraph', target).pixels;
  whole.dispose();

  const before = JSON.stringify(objects.counts());
  const steps: { file: string; bytesBefore: number; psnrDb: number | null; timeS: number }[] = [];
  let startMs = performance.now();
  let shown: LoadedCapture | null = null;
  let loadedBytes = 0;
  const image = (capture: LoadedCapture) => draw(gl, capture, 'lumigraph', target).pixels;
  const quality = (capture: LoadedCapture): number =>
    compareImages({ shown: image(capture), truth, widthPx: target.widthPx, heightPx: target.heightPx }).psnrDb;
  const load = async (path: string): Promise<ArrayBuffer> => {
    const timeS = (performance.now() - startMs) / 1000;
    const psnrDb = shown && quality(shown);
    startMs = performance.now() - 1000 * timeS;
    steps.push({ file: path, bytesBefore: loadedBytes, psnrDb, timeS });
    const content = await source.load(path);
    loadedBytes += content.byteLength;
    return content;
  };
  startMs = performance.now();
  const show = (early: LoadedCapture): void => {
    shown = early;
  };
  const capture = await loadCapture(objects, bytes, file, load, false, show, delay);
  const equalsWhole = image(capture).every((value, i) => value === truth[i]);
  capture.dispose();

  let requested = 0;
  let early: LoadedCapture | null = null;
  const interrupted = async (path: string): Promise<ArrayBuffer> => {
    if (++requested === 4) early?.dispose();
    return source.load(path);
  };
  const keep = (value: LoadedCapture): void => {
    early = value;
  };
  await loadCapture(objects, bytes, file, interrupted, false, keep, delay);
  early = null;
  let waits = 0;
  const disposing = async (delayS: number): Promise<void> => {
    if (early && ++waits === 3) early.dispose();
    await delay(delayS);
  };
  await loadCapture(objects, bytes, file, source.load, false, keep, disposing);
  if (waits < 3) throw new Error('The capture was not disposed between two parts.');
  const leaks = JSON.stringify(objects.counts()) !== before;
  const error = gl.getError();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { steps, totalBytes: loadedBytes, equalsWhole, leaks, error };
}

/**
 * Loads the other photographs of a capture of a page as the page does, and compares what it shows from the camera of a view with its photograph
 * before each file that it requests. The time in which the test draws and compares does not count.
 */
export async function rephotographWhileLoading(
  baseUrl: string,
  file: string,
  view: number,
): Promise<LoadingCurve & { readonly error: number }> {
  const source = createFetchAssetSource(new URL(baseUrl, location.href).href, (...args: Parameters<typeof fetch>) => fetch(...args));
  const document = readCapture(new TextDecoder().decode(await source.load(file)));
  const target = document.views[view];
  if (!target) throw new Error(`There is no view ${view}.`);
  const others = new TextEncoder().encode(
    JSON.stringify({ ...document, views: document.views.filter((other) => other !== target) }),
  ).buffer;
  const { widthPx, heightPx } = target;
  const folder = file.slice(0, file.lastIndexOf('/') + 1);
  const truth = await photoPixels(await source.load(folder + target.file), widthPx, heightPx);
  const gl = createGl(widthPx, heightPx);
  const quality = (capture: LoadedCapture): number =>
    compareImages({ shown: draw(gl, capture, 'lumigraph', target).pixels, truth, widthPx, heightPx }).psnrDb;
  const steps: { timeS: number; psnrDb: number }[] = [];
  let shown: LoadedCapture | null = null;
  let startMs = performance.now();
  const load = async (path: string): Promise<ArrayBuffer> => {
    const timeS = (performance.now() - startMs) / 1000;
    if (shown) steps.push({ timeS, psnrDb: quality(shown) });
    startMs = performance.now() - 1000 * timeS;
    return source.load(path);
  };
  const capture = await loadCapture(createGlObjects(gl), others, file, load, false, (early) => {
    shown = early;
  });
  const finalDb = quality(capture);
  capture.dispose();
  const error = gl.getError();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { steps, finalDb, error };
}
