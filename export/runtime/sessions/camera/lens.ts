import { setDeviceRotation } from '../../../../nodes/kit/device-orientation.ts';
import { createMatrix } from '../matrix.ts';
import { LONG_SIDE_FOV_RAD } from './camera-view.ts';
import { createFovEstimator } from './estimate-fov.ts';
import type { OrientationSensor } from './orientation-sensor.ts';

/** The field of view of a camera, which is assumed first and estimated while the device turns. */
export interface Lens {
  /** Tangent of half the field of view of the longer side. It changes slowly, so that objects do not jump. */
  readonly tanHalfLongSide: number;
  /** Takes a new image of the video into account. */
  look(video: HTMLVideoElement): void;
  /** Moves `tanHalfLongSide` towards the estimate. Called once per frame. */
  update(deltaS: number): void;
}

/** Longer side of the images that are compared, pixels: enough to measure shifts of 0.1 px, and small enough for a millisecond. */
const LONG_SIDE_PX = 80;
const TIME_CONSTANT_S = 0.5;

export type CreateLens = (document: Document, sensor: Pick<OrientationSensor, 'angles' | 'present'>) => Lens;

export const createLens: CreateLens = (document, sensor) => {
  let tanHalfLongSide = Math.tan(LONG_SIDE_FOV_RAD / 2);
  const estimator = createFovEstimator(tanHalfLongSide);
  const worldFromCamera = createMatrix();
  let context: CanvasRenderingContext2D | null = null;
  let luminance = new Float32Array(0);

  function readLuminance(video: HTMLVideoElement): boolean {
    const scale = LONG_SIDE_PX / Math.max(video.videoWidth, video.videoHeight);
    const widthPx = Math.round(video.videoWidth * scale);
    const heightPx = Math.round(video.videoHeight * scale);
    if (!(widthPx > 0 && heightPx > 0)) return false;
    context ??= document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    if (!context) return false;
    if (context.canvas.width !== widthPx || context.canvas.height !== heightPx) {
      context.canvas.width = widthPx;
      context.canvas.height = heightPx;
    }
    // Without it, browsers skip pixels when they shrink, and the picture flickers.
    context.imageSmoothingQuality = 'high';
    context.drawImage(video, 0, 0, widthPx, heightPx);
    const { data } = context.getImageData(0, 0, widthPx, heightPx);
    if (luminance.length !== widthPx * heightPx) luminance = new Float32Array(widthPx * heightPx);
    // Rec. 709 weights.
    for (let i = 0; i < luminance.length; i++) {
      luminance[i] = 0.2126 * (data[4 * i] ?? 0) + 0.7152 * (data[4 * i + 1] ?? 0) + 0.0722 * (data[4 * i + 2] ?? 0);
    }
    return true;
  }

  return {
    get tanHalfLongSide() {
      return tanHalfLongSide;
    },
    look: (video) => {
      if (!sensor.present || estimator.isDone || !readLuminance(video) || !context) return;
      setDeviceRotation(worldFromCamera, sensor.angles);
      const { width, height } = context.canvas;
      if (estimator.add(luminance, width, height, worldFromCamera)) luminance = new Float32Array(luminance.length);
    },
    update: (deltaS) => {
      const known = estimator.tanHalfLongSide;
      if (known !== null) tanHalfLongSide += (known - tanHalfLongSide) * (1 - Math.exp(-deltaS / TIME_CONSTANT_S));
    },
  };
};
