import type { CaptureView } from '../../../nodes/kit/capture.ts';
import { pictureSize, takePhotograph } from '../acquire/take-photograph.ts';
import { chromaErrorMap, compareImages, type ImageQuality } from './image-quality.ts';

export const REPHOTOGRAPH_METHODS = ['plain', 'nearest', 'lumigraph', 'depth-meshes'] as const;

/** A method of the node Capture. */
export type RephotographMethod = (typeof REPHOTOGRAPH_METHODS)[number];

/** A photograph, drawn from all others by one method. */
export interface Rephotograph extends ImageQuality {
  readonly method: RephotographMethod;
  /** RGBA, 8 bits, rows from the top; alpha is 0 where nothing is. */
  readonly shown: Uint8Array<ArrayBuffer>;
  /** The error of Cb and Cr, as a picture of the same form. */
  readonly error: Uint8ClampedArray<ArrayBuffer>;
}

type Pinhole = Pick<CaptureView, 'widthPx' | 'heightPx' | 'fxPx' | 'fyPx' | 'cxPx' | 'cyPx' | 'worldFromCamera'>;

/** Draws a capture without one of its photographs: `createRephotographer` of the runtime. */
interface LeaveOneOut {
  readonly views: readonly CaptureView[];
  photo(index: number): Promise<ArrayLike<number>>;
  leaveOut(index: number): void;
  draw(method: RephotographMethod, camera: Pinhole): Uint8Array<ArrayBuffer>;
}

/** Draws a photograph from all others by one method. */
export type DrawRephotograph = (method: RephotographMethod) => Promise<Rephotograph>;

/**
 * Leaves out a photograph, which is then drawn from all others at its own size and compared. A 360° photograph is drawn from six pinhole
 * cameras.
 *
 * @returns What draws it, until another photograph is left out.
 * @throws Error if there is no view `index`, or this computer cannot draw its size.
 *
 * @example
 * const draw = await rephotograph(capture, 3);
 * const { psnrDb } = await draw('lumigraph');
 */
export async function rephotograph(capture: LeaveOneOut, index: number): Promise<DrawRephotograph> {
  const view = capture.views[index];
  if (!view) throw new Error(`There is no view ${index}.`);
  const { widthPx, heightPx } = view;
  const isAround = view.projection === 'equirectangular';
  const truth = await capture.photo(index);
  capture.leaveOut(index);
  return async (method) => {
    const draw = (camera: Pinhole) => capture.draw(method, camera);
    const shown = isAround ? await drawAround(view, draw) : draw(view);
    const pair = { shown, truth, widthPx, heightPx, isAround };
    return { method, shown, error: chromaErrorMap(pair), ...compareImages(pair) };
  };
}

async function drawAround(
  { widthPx, heightPx, worldFromCamera }: CaptureView,
  draw: (camera: Pinhole) => Uint8Array<ArrayBuffer>,
): Promise<Uint8Array<ArrayBuffer>> {
  const camera = { projection: 'equirectangular', widthPx, heightPx } as const;
  const [sidePx] = pictureSize(camera);
  const size = { widthPx: sidePx, heightPx: sidePx };
  // Only colors are compared.
  const depth = { ...size, meters: new Float32Array(sidePx * sidePx) };
  const { color } = await takePhotograph(camera, worldFromCamera, async (pose, [tangent]) => {
    const [focalPx, centerPx] = [sidePx / 2 / tangent, sidePx / 2];
    const face = { ...size, fxPx: focalPx, fyPx: focalPx, cxPx: centerPx, cyPx: centerPx, worldFromCamera: pose };
    return { color: { ...size, pixels: draw(face) }, depth };
  });
  return color.pixels;
}
