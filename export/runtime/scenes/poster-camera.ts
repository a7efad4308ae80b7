import { Box3, Matrix4, Vector3 } from 'three';
import {
  cropAt,
  cropOf,
  type PosterFraming,
  tangentsOf,
  type ViewCrop,
  type ViewTangents,
  WHOLE_VIEW,
} from '../../../nodes/kit/poster-framing.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { Inspected } from '../inspected.ts';
import { drawnObjects } from './placed-objects.ts';

/** What `player.inspect` returns of the last frame. */
type Seen = Pick<Inspected, 'program' | 'resources' | 'engine'>;

/** Aims the camera for a poster. */
export interface PosterCamera {
  /**
   * Called after a frame, before that of the poster: moves the head where the session has one. Returns the size in which the frame of the
   * poster must be rendered, so that the part that is kept has enough pixels. Sessions whose head cannot be moved cut their image to the
   * shape of the canvas, so their frame keeps the shape of the view.
   */
  aim(): PosterSize;
  /** Called after the frame of the poster: the part of its first view that the poster shows. */
  crop(): ViewCrop;
  /** Gives the head back. */
  release(): void;
}

/** Size in pixels. */
export interface PosterSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

export interface PosterCameraOptions {
  readonly inspect: () => Seen | null;
  /** Sets the pose of the head, column-major 4×4; null gives it back. Null for sessions whose pose cannot be set. */
  readonly setHead: ((worldFromHead: Float32Array | null) => void) | null;
  /** The framing that a person chose; null: the objects are framed. */
  readonly framing: PosterFraming | null;
  /** Nodes of the program whose objects are framed; if it is empty or they have none, all objects are. */
  readonly nodes: readonly string[];
  /** Size of the poster. */
  readonly size: PosterSize;
}

/** Fraction of the poster's width or height that framed objects fill. */
const FILLED = 0.72;
/** Most enlargement by cropping. Parts of a recording that are smaller would be blurred. */
const MAX_ZOOM = 2;
/** The head comes no nearer to the center of the objects. */
const MIN_DISTANCE_M = 0.3;
/** The head is moved back by no more than this, because there may be a wall. */
const MAX_BACK_M = 1.5;
/** Larger objects, such as grounds and skies, are surroundings. */
const MAX_OBJECT_M = 8;
const UP = new Vector3(0, 1, 0);

/** Creates the camera of a poster. Its functions allocate, because they run once per poster. */
export function createPosterCamera({ inspect, setHead, framing, nodes, size }: PosterCameraOptions): PosterCamera {
  let posed = false;
  const shape = size.widthPx / size.heightPx;
  const viewOf = (seen: Seen | null) => seen?.engine.state.frame.views[0] ?? null;
  const look = (eye: Vector3, target: Vector3) => {
    posed = true;
    setHead?.(Float32Array.from(new Matrix4().lookAt(eye, target, UP).setPosition(eye).elements));
  };
  const cropNow = (): ViewCrop => {
    const seen = inspect();
    const view = viewOf(seen);
    if (!seen || !view) return WHOLE_VIEW;
    const tangents = tangentsOf(view.clipFromView);
    if (framing) return cropOf(framing, tangents, shape);
    const viewShape = shapeOf(tangents);
    const whole = cropAt([0.5, 0.5], 1, shape / viewShape);
    const points = posed ? [] : cornersOf(seen, nodes);
    return cropAround(points, view, shape / viewShape) ?? whole;
  };
  return {
    aim: () => {
      const seen = inspect();
      const view = viewOf(seen);
      if (framing?.room && setHead) look(new Vector3(...framing.room.eye), new Vector3(...framing.room.target));
      else if (!framing && setHead && seen && view) {
        const points = cornersOf(seen, nodes);
        if (points.length > 0) look(...placeFor(points, view, shape));
      }
      const zoom = posed && !framing ? 1 : Math.min(Math.max(1 / cropNow().height, 1), MAX_ZOOM);
      const kept = setHead || !view ? shape : shapeOf(tangentsOf(view.clipFromView));
      return { widthPx: Math.round(size.heightPx * zoom * kept), heightPx: Math.round(size.heightPx * zoom) };
    },
    crop: cropNow,
    release: () => {
      if (posed) setHead?.(null);
      posed = false;
    },
  };
}

const shapeOf = ({ left, right, bottom, top }: ViewTangents): number => (right - left) / (top - bottom);

/** Corners of the boxes around the visible virtual objects that passed through one of the nodes; of all if none did. */
function cornersOf(seen: Seen, nodes: readonly string[]): Vector3[] {
  const boxes = drawnObjects(seen).flatMap(({ way, item }) => {
    if (item.hidden || item.role === 'phantom') return [];
    const box = new Box3().setFromObject(item.root).applyMatrix4(item.worldFromObject);
    const sizeM = box.getSize(new Vector3()).length();
    return box.isEmpty() || !(sizeM < MAX_OBJECT_M) ? [] : [{ way, box }];
  });
  const chosen = boxes.filter(({ way }) => way.some((id) => nodes.some((node) => id === node || id.startsWith(`${node}/`))));
  return (chosen.length > 0 ? chosen : boxes).flatMap(({ box: { min, max } }) =>
    [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z)))),
  );
}

/** Eye and target that show all points, seen from the side of the current view. */
function placeFor(points: readonly Vector3[], view: ViewFrame, shape: number): [eye: Vector3, target: Vector3] {
  const center = new Box3().setFromPoints([...points]).getCenter(new Vector3());
  const eye = new Vector3().setFromMatrixPosition(new Matrix4().fromArray(view.worldFromView));
  const back = eye.clone().sub(center);
  const nowM = back.length();
  if (nowM < 1e-3) back.set(0, 0, 1);
  back.normalize();
  const right = new Vector3().crossVectors(UP, back).normalize();
  const up = new Vector3().crossVectors(back, right);
  const { top } = tangentsOf(view.clipFromView);
  const [perHeight, perWidth] = [1 / (top * FILLED), 1 / (top * shape * FILLED)];
  // A point at `offset` from the center is inside if its offset across is within the field of view at its depth.
  const fits = points.map((point) => {
    const offset = point.clone().sub(center);
    const across = Math.max(Math.abs(offset.dot(up)) * perHeight, Math.abs(offset.dot(right)) * perWidth);
    return across + offset.dot(back);
  });
  const distanceM = Math.min(Math.max(MIN_DISTANCE_M, ...fits), Math.max(nowM, MIN_DISTANCE_M) + MAX_BACK_M);
  return [center.clone().addScaledVector(back, distanceM), center];
}

/** The part of a view around points; null if there are none, or if none is in view. */
function cropAround(points: readonly Vector3[], view: ViewFrame, shape: number): ViewCrop | null {
  const clipFromWorld = new Matrix4().fromArray(view.clipFromView).multiply(new Matrix4().fromArray(view.viewFromWorld));
  const viewFromWorld = new Matrix4().fromArray(view.viewFromWorld);
  const seen = points
    .filter((point) => point.clone().applyMatrix4(viewFromWorld).z < -view.nearM)
    .map((point) => point.clone().applyMatrix4(clipFromWorld))
    .map(({ x, y }) => [0.5 + x / 2, 0.5 - y / 2] as const);
  const [xs, ys] = [seen.map(([x]) => x), seen.map(([, y]) => y)];
  const [left, right] = [Math.max(Math.min(...xs), 0), Math.min(Math.max(...xs), 1)];
  const [top, bottom] = [Math.max(Math.min(...ys), 0), Math.min(Math.max(...ys), 1)];
  if (!(left < right && top < bottom)) return null;
  const height = Math.max((bottom - top) / FILLED, (right - left) / FILLED / shape, 1 / MAX_ZOOM);
  return cropAt([(left + right) / 2, (top + bottom) / 2], height, shape);
}
