import { CaptureError, type Pinhole } from '../../../nodes/kit/capture.ts';
import { type Lens, project } from '../lens.ts';

/** Depth of each pixel, rows from the top. Values that are not above 0 are unknown. */
export interface DepthMap {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly values: Float32Array;
}

/** What depth means: the distance along the axis of the camera, or along the ray of the pixel. */
export type DepthKind = 'z' | 'ray';

/** How far the shape of a depth map may differ from that of its photograph. */
const SHAPE_TOLERANCE = 0.01;

/**
 * Checks that a map has the shape of its photograph and at least one depth.
 *
 * @throws CaptureError
 */
export function checkDepthMap({ widthPx, heightPx, values }: DepthMap, name: string, photo: Pick<Lens, 'widthPx' | 'heightPx'>): void {
  if (Math.abs((widthPx * photo.heightPx) / (heightPx * photo.widthPx) - 1) > SHAPE_TOLERANCE) {
    throw new CaptureError(
      `the depth of ${name} is ${widthPx} × ${heightPx} pixels, but the photograph ${photo.widthPx} × ${photo.heightPx}, which has another shape`,
    );
  }
  if (!values.some(isKnown)) throw new CaptureError(`the depth of ${name} has no value above 0`);
}

/**
 * The depth that a pinhole camera sees, in the place and direction of the lens, along its axis. No value is a mean: at edges, a mean would
 * be a depth where nothing is.
 *
 * @param map In the pixels of the lens, perhaps of another size.
 * @param scale Factor of all depths.
 */
export function depthForPinhole(map: DepthMap, lens: Lens, pinhole: Pinhole, kind: DepthKind, scale: number): DepthMap {
  const { widthPx, heightPx } = pinhole;
  const values = new Float32Array(widthPx * heightPx);
  const place = new Float64Array(2);
  // A 360° camera has no axis: all depths are distances.
  const isAlongRay = kind === 'ray' && pinhole.projection === undefined;
  const perColumn = map.widthPx / lens.widthPx;
  const perRow = map.heightPx / lens.heightPx;
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const x = (column + 0.5 - pinhole.cxPx) / pinhole.fxPx;
      const y = (row + 0.5 - pinhole.cyPx) / pinhole.fyPx;
      project(lens, x, y, place);
      const fromColumn = Math.floor((place[0] ?? 0) * perColumn);
      const fromRow = Math.floor((place[1] ?? 0) * perRow);
      if (fromColumn < 0 || fromRow < 0 || fromColumn >= map.widthPx || fromRow >= map.heightPx) continue;
      const depth = map.values[fromRow * map.widthPx + fromColumn] ?? 0;
      if (isKnown(depth)) values[row * widthPx + column] = (depth * scale) / (isAlongRay ? Math.hypot(x, y, 1) : 1);
    }
  }
  return { widthPx, heightPx, values };
}

/** Whether a depth is known: finite and above 0. Renderers write infinity, or 10,000,000,000, where there is nothing. */
export function isKnown(depth: number): boolean {
  return depth > 0 && depth < 1e9;
}

/** The pinhole camera of a map that is at most as large as the photograph. */
export function pinholeOfDepth(pinhole: Pinhole, map: Pick<DepthMap, 'widthPx'>): Pinhole {
  return scaledPinhole(pinhole, Math.min(1, map.widthPx / pinhole.widthPx));
}

/** The same camera with fewer pixels. */
export function scaledPinhole(pinhole: Pinhole, factor: number): Pinhole {
  const { widthPx, heightPx, fxPx, fyPx, cxPx, cyPx } = pinhole;
  const width = Math.max(1, Math.round(widthPx * factor));
  const height = Math.max(1, Math.round(heightPx * factor));
  const [sx, sy] = [width / widthPx, height / heightPx];
  return { ...pinhole, widthPx: width, heightPx: height, fxPx: fxPx * sx, fyPx: fyPx * sy, cxPx: cxPx * sx, cyPx: cyPx * sy };
}
