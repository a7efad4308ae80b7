import type { ImageQuality } from '../../../export/captures/evaluate/image-quality.ts';
import { type RephotographMethod, rephotograph } from '../../../export/captures/evaluate/rephotograph.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createRephotographer, type Rephotographer } from '../../../export/runtime/rephotographer.ts';

/** One photograph, drawn from all others by one method. The pictures are data URLs of PNG files. */
export interface RephotographShot extends ImageQuality {
  readonly method: RephotographMethod;
  readonly picture: string;
  /** The error of Cb and Cr. */
  readonly error: string;
}

let opened: { readonly capture: Rephotographer; readonly methods: readonly RephotographMethod[] } | null = null;

/**
 * Loads a capture.
 *
 * @param blended Number of photographs per pixel (lumigraph).
 * @returns The number of its views.
 * @throws CaptureError
 */
export async function open(baseUrl: string, methods: readonly RephotographMethod[], blended: number): Promise<number> {
  const { load } = createFetchAssetSource(new URL(baseUrl, document.baseURI).href, fetch.bind(globalThis));
  const gl = document.createElement('canvas').getContext('webgl2', { alpha: true, antialias: false, depth: true });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const capture = await createRephotographer(gl, load, methods, blended);
  opened = { capture, methods };
  return capture.views.length;
}

/** Draws the photograph `index` at its own size from all others, which also give the colors of the mesh. */
export async function rephotographView(index: number): Promise<readonly RephotographShot[]> {
  const view = opened?.capture.views[index];
  if (!opened || !view) throw new Error(`There is no view ${index}.`);
  const draw = await rephotograph(opened.capture, index);
  const shots: RephotographShot[] = [];
  for (const method of opened.methods) {
    const { shown, error, ...shot } = await draw(method);
    const url = (pixels: ArrayLike<number>) => pictureUrl(pixels, view.widthPx, view.heightPx);
    shots.push({ ...shot, picture: url(shown), error: url(error) });
  }
  return shots;
}

/** A PNG of RGBA pixels, rows from the top, as a data URL. */
function pictureUrl(pixels: ArrayLike<number>, widthPx: number, heightPx: number): string {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: widthPx, height: heightPx });
  canvas.getContext('2d')?.putImageData(new ImageData(Uint8ClampedArray.from(pixels), widthPx, heightPx), 0, 0);
  return canvas.toDataURL('image/png');
}
