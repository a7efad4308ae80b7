import { basename } from 'node:path';
import { pickPoint } from '../../export/captures/pick-point.ts';
import { type Axis, uprightPoint } from '../../export/captures/upright.ts';
import { CaptureError, type CaptureMesh } from '../../nodes/kit/capture.ts';
import type { FoundView } from './read-capture-folder.ts';

/** A place in a photograph: pixels from its left and top edges. */
export interface PhotoPlace {
  /** Name of the photograph, with or without its folder. */
  readonly photo: string;
  readonly column: number;
  readonly row: number;
}

/** What is known about the size of a place. Null: nothing. */
export interface KnownSize {
  /** Two points whose distance is known. */
  readonly distance: { readonly from: PhotoPlace; readonly to: PhotoPlace; readonly meters: number } | null;
  /** A point of the floor, which comes to height 0. */
  readonly floor: PhotoPlace | null;
  /** How high the camera of the photograph with that point was above the floor. */
  readonly cameraHeightM: number | null;
}

export const UNKNOWN_SIZE: KnownSize = { distance: null, floor: null, cameraHeightM: null };

/** Meters per unit of the reconstruction, and the height of the floor with that scale, after `up` has become +y. */
export interface MeasuredSize {
  readonly metersPerUnit: number;
  readonly floorM: number;
}

/**
 * Finds the scale and the floor of a reconstruction from points that are named by their places in photographs.
 *
 * @param mesh In the space of the reconstruction.
 * @param metersPerUnit The scale if neither a distance nor a height is known.
 * @throws CaptureError
 */
export function measureCapture(
  { distance, floor, cameraHeightM }: KnownSize,
  views: readonly FoundView[],
  mesh: CaptureMesh | null,
  up: Axis,
  metersPerUnit: number,
): MeasuredSize {
  if (distance === null && floor === null) return { metersPerUnit, floorM: 0 };
  if (!mesh) throw new CaptureError('a distance or the floor can be measured on a mesh only, but the folder has none');
  const pointAt = (place: PhotoPlace) => pointOf(place, viewOf(place, views), mesh);
  let scale = metersPerUnit;
  if (distance) {
    const [a, b] = [pointAt(distance.from), pointAt(distance.to)];
    const units = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    if (units === 0) throw new CaptureError('the two points whose distance is known are the same');
    scale = distance.meters / units;
  }
  if (!floor) return { metersPerUnit: scale, floorM: 0 };
  const floorUnits = uprightPoint(up, pointAt(floor))[1];
  if (cameraHeightM !== null) {
    const [x = 0, y = 0, z = 0] = viewOf(floor, views).view.worldFromCamera.slice(12, 15);
    const units = uprightPoint(up, [x, y, z])[1] - floorUnits;
    if (units <= 0)
      throw new CaptureError(`the camera of ${floor.photo} is not above the point of the floor. Choose another one, or name --up`);
    scale = cameraHeightM / units;
  }
  return { metersPerUnit: scale, floorM: floorUnits * scale };
}

function viewOf({ photo }: PhotoPlace, views: readonly FoundView[]): FoundView {
  const exact = views.filter(({ view }) => view.name === photo);
  const found = exact.length > 0 ? exact : views.filter(({ view }) => basename(view.name) === photo);
  const [view] = found;
  if (!view) throw new CaptureError(`it has no photograph ${JSON.stringify(photo)}, only such as ${views[0]?.view.name}`);
  if (found.length > 1)
    throw new CaptureError(`it has several photographs ${JSON.stringify(photo)}. Name one with its folder, such as ${view.view.name}`);
  if (view.lens.projection === 'equirectangular') throw new CaptureError(`${photo} is a 360° photograph, in which no points can be named`);
  return view;
}

function pointOf({ photo, column, row }: PhotoPlace, { view, lens }: FoundView, mesh: CaptureMesh): readonly [number, number, number] {
  const { widthPx, heightPx } = lens;
  if (column < 0 || row < 0 || column > widthPx || row > heightPx) {
    throw new CaptureError(`${column},${row} is outside of ${photo}, which has ${widthPx} × ${heightPx} pixels`);
  }
  const point = pickPoint(mesh, lens, view.worldFromCamera, column, row);
  if (!point) throw new CaptureError(`there is no mesh at ${column},${row} of ${photo}. Choose a point that the mesh shows`);
  return point;
}
