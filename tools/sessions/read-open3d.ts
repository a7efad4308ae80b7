import type { Intrinsics } from '../../export/runtime/sessions/session-format.ts';
import { type Matrix, multiply } from './vector.ts';

/** A recording with pinhole cameras and known poses, such as those of Open3D’s reconstruction system. */
export interface PosedRecording {
  readonly title: string;
  readonly credit: string | null;
  readonly licence: string | null;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly intrinsics: Intrinsics;
  readonly metresPerUnit: number;
  readonly frameRateHz: number;
  readonly frames: readonly PosedFrame[];
}

export interface PosedFrame {
  readonly timeS: number;
  readonly color: string;
  readonly depth: string;
  /** Pose of the camera in the world space of the recording, with the camera axes of sessions: looking along −z, y up. */
  readonly worldFromCamera: Matrix;
}

/** OpenCV’s cameras look along +z with y down. */
const OPENCV_FROM_CAMERA: Matrix = [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1];
/** OpenCV measures from the center of the top left pixel, sessions from its corner. */
const CENTER_SHIFT_PX = 0.5;

type Json = Readonly<Record<string, unknown>>;

/**
 * Reads the layout `{ width, height, intrinsics: { fx, fy, cx, cy }, depth: { unit_m, kind }, fps, frames: [{ t, color, depth,
 * cameraToWorld }] }` with row-major 4×4 poses, OpenCV axes and pixel centers at whole numbers.
 *
 * @throws Error that names what is missing.
 */
export function readOpen3d(json: unknown): PosedRecording {
  const file = object(json, 'the file');
  const intrinsics = object(file.intrinsics, '"intrinsics"');
  const depth = object(file.depth, '"depth"');
  if (typeof depth.kind === 'string' && !/\bz\b/i.test(depth.kind))
    throw new Error(`"depth.kind" is "${depth.kind}"; depth along the camera's axis (z) is needed`);
  if (!Array.isArray(file.frames) || file.frames.length === 0) throw new Error('"frames" has to be a list of at least one frame');
  const frameRateHz = number(file.fps, '"fps"');
  return {
    title: text(file.description) ?? 'Converted recording',
    credit: text(file.source),
    licence: text(file.licence),
    widthPx: number(file.width, '"width"'),
    heightPx: number(file.height, '"height"'),
    intrinsics: {
      fxPx: number(intrinsics.fx, '"intrinsics.fx"'),
      fyPx: number(intrinsics.fy, '"intrinsics.fy"'),
      cxPx: number(intrinsics.cx, '"intrinsics.cx"') + CENTER_SHIFT_PX,
      cyPx: number(intrinsics.cy, '"intrinsics.cy"') + CENTER_SHIFT_PX,
    },
    metresPerUnit: number(depth.unit_m, '"depth.unit_m"'),
    frameRateHz,
    frames: file.frames.map((frame: unknown, i) => readFrame(object(frame, `frame ${i}`), i, frameRateHz)),
  };
}

function readFrame(frame: Json, index: number, frameRateHz: number): PosedFrame {
  const pose = frame.cameraToWorld;
  if (!Array.isArray(pose) || pose.length !== 16 || !pose.every((n) => typeof n === 'number' && Number.isFinite(n))) {
    throw new Error(`"cameraToWorld" of frame ${index} has to be 16 numbers`);
  }
  return {
    timeS: typeof frame.t === 'number' ? frame.t : index / frameRateHz,
    color: path(frame.color, `"color" of frame ${index}`),
    depth: path(frame.depth, `"depth" of frame ${index}`),
    worldFromCamera: fromOpenCv(pose),
  };
}

/** Converts a row-major pose with OpenCV’s axes to a column-major `worldFromCamera`. */
export function fromOpenCv(rowMajor: readonly number[]): Matrix {
  const columnMajor = Array.from({ length: 16 }, (_, i) => Number(rowMajor[(i % 4) * 4 + Math.floor(i / 4)]));
  return multiply(columnMajor, OPENCV_FROM_CAMERA);
}

function object(value: unknown, what: string): Json {
  if (typeof value !== 'object' || value === null) throw new Error(`${what} has to be an object`);
  return value as Json;
}

function number(value: unknown, what: string): number {
  if (typeof value !== 'number' || !Number.isFinite(value) || value <= 0) throw new Error(`${what} has to be a number above 0`);
  return value;
}

function text(value: unknown): string | null {
  return typeof value === 'string' && value !== '' ? value : null;
}

/** Reads a path, which must lie inside the folder of the recording, because its files are copied. */
function path(value: unknown, what: string): string {
  if (typeof value !== 'string' || value === '' || /^[/\\]|\\|:/.test(value) || value.split('/').includes('..')) {
    throw new Error(`${what} has to be the path of a file inside the folder`);
  }
  return value;
}
