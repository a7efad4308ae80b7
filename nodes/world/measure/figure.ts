import { Vector3 } from 'three';
import type { SeenPoint } from './propagate.ts';

export type Mode = 'distance' | 'polyline' | 'height' | 'angle' | 'rectangle' | 'polygon' | 'box';

/** The least number of points that a measurement of each mode needs. */
export const LEAST: Readonly<Record<Mode, number>> = { distance: 2, polyline: 2, height: 1, angle: 3, rectangle: 3, polygon: 3, box: 4 };

/** The greatest number of points that a measurement of each mode can have. */
export const MOST: Readonly<Record<Mode, number>> = { distance: 2, polyline: 32, height: 1, angle: 3, rectangle: 3, polygon: 32, box: 4 };

/** The lines and ends to draw for a measurement, meters, world space. The object is reused. */
export interface Figure {
  /** The ends of the lines, in pairs: line `i` is from `lines[2 i]` to `lines[2 i + 1]`, for `i` below `lineCount`. */
  readonly lines: readonly Vector3[];
  lineCount: number;
  readonly ends: readonly Vector3[];
  endCount: number;
}

const MAX_LINES = 33;

// Filled and read within one call.
const scratchAcross = new Vector3();
const scratchUp = new Vector3();
const corners = Array.from({ length: 8 }, () => new Vector3());

export function createFigure(): Figure {
  const make = (length: number) => Array.from({ length }, () => new Vector3());
  return { lines: make(2 * MAX_LINES), lineCount: 0, ends: make(MAX_LINES), endCount: 0 };
}

/**
 * Writes the lines and ends that show the first `count` points. While points are missing, it writes the lines between those that are set.
 */
export function writeFigure(figure: Figure, mode: Mode, points: readonly SeenPoint[], count: number): void {
  figure.lineCount = 0;
  figure.endCount = 0;
  const at = (i: number, out: Vector3): Vector3 => out.fromArray(points[i]?.positionM ?? [0, 0, 0]);
  const line = (a: Vector3, b: Vector3): void => {
    const i = figure.lineCount;
    if (i >= MAX_LINES) return;
    figure.lines[2 * i]?.copy(a);
    figure.lines[2 * i + 1]?.copy(b);
    figure.lineCount++;
  };
  for (let i = 0; i < count; i++) {
    const end = figure.ends[figure.endCount];
    if (end) at(i, end);
    figure.endCount++;
  }
  const { ends } = figure;
  if (mode === 'height') {
    const [top] = ends;
    if (count > 0 && top) line(top, scratchUp.copy(top).setY(0));
    return;
  }
  if ((mode === 'rectangle' || mode === 'box') && count >= 3) {
    writeCorners(points, mode === 'box' && count >= 4);
    const layers = mode === 'box' && count >= 4 ? 2 : 1;
    for (let i = 0; i < 4; i++) {
      for (let layer = 0; layer < layers; layer++) {
        line(corners[4 * layer + i] as Vector3, corners[4 * layer + ((i + 1) % 4)] as Vector3);
      }
      if (layers === 2) line(corners[i] as Vector3, corners[4 + i] as Vector3);
    }
    return;
  }
  for (let i = 0; i + 1 < count; i++) line(ends[i] as Vector3, ends[i + 1] as Vector3);
  if (mode === 'polygon' && count >= 3) line(ends[count - 1] as Vector3, ends[0] as Vector3);
}

/** Writes the corners of the rectangle with the side from A to B, through C; for a box, also those of the face through D. */
function writeCorners(points: readonly SeenPoint[], isBox: boolean): void {
  const [a, b, c, d] = corners as [Vector3, Vector3, Vector3, Vector3];
  const at = (i: number, out: Vector3): Vector3 => out.fromArray(points[i]?.positionM ?? [0, 0, 0]);
  at(0, a);
  at(1, b);
  at(2, c);
  const side = scratchUp.subVectors(b, a).normalize();
  scratchAcross.subVectors(c, b);
  scratchAcross.addScaledVector(side, -scratchAcross.dot(side));
  c.copy(b).add(scratchAcross);
  d.copy(a).add(scratchAcross);
  if (!isBox) return;
  const top = corners[4] as Vector3;
  const normal = side.cross(scratchAcross).normalize();
  const heightM = at(3, top).sub(a).dot(normal);
  for (let i = 0; i < 4; i++) corners[4 + i]?.copy(corners[i] as Vector3).addScaledVector(normal, heightM);
}
