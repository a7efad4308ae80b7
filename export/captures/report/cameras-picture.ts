import type { CaptureView } from '../../../nodes/kit/capture.ts';

type Point = readonly [number, number, number];
type Place = readonly [number, number];

/** From where a place is looked at: turned about the vertical axis, then tilted; radians. At 0 and 0, x is to the right and y up. */
export interface Side {
  readonly yawRad: number;
  readonly pitchRad: number;
}

/** The sides from which a place is shown. */
export const SIDES: readonly (Side & { readonly caption: string })[] = [
  { caption: 'From above', yawRad: 0, pitchRad: Math.PI / 2 },
  { caption: 'From the front', yawRad: 0, pitchRad: 0 },
  { caption: 'At an angle', yawRad: 0.6, pitchRad: 0.55 },
];

/** A drawing as paths of SVG. */
export interface CamerasPicture {
  readonly viewBox: string;
  /** Points of the mesh, as lines without length. */
  readonly mesh: string;
  /** The outline of each camera. */
  readonly cameras: readonly string[];
}

/** A part of a picture, in its own units. */
interface Frame {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Width and height of a picture in units of SVG, without its margin. */
const SIZE = 1000;
const MARGIN = 60;
/** What a turning picture leaves out at each edge: a place fills its ball nowhere near these. */
const CROP = 140;
/** Length of a drawn camera. */
const CAMERA = 55;
/** The share of points beyond each edge, which are left out: reconstructions have stray triangles far away. */
const STRAY = 0.005;

/** Draws cameras over the points of a mesh. Without `ball`, the picture fits what it shows. */
export function camerasPicture(
  { yawRad, pitchRad }: Side,
  surface: ArrayLike<number>,
  views: readonly CaptureView[],
  ball: Ball | null = null,
): CamerasPicture {
  const [c, s] = [Math.cos(yawRad), Math.sin(yawRad)];
  const [rise, along] = [Math.cos(pitchRad), Math.sin(pitchRad)];
  const flat = (x: number, y: number, z: number): Place => [x * c - z * s, x * s * along - y * rise + z * c * along];
  const places = Array.from({ length: surface.length / 3 }, (_, i) =>
    flat(surface[3 * i] ?? 0, surface[3 * i + 1] ?? 0, surface[3 * i + 2] ?? 0),
  );
  const { left, top, right, bottom } = ball === null ? fitted(places, centersOf(views, flat)) : around(flat(...ball.center), ball.radius);
  const scale = SIZE / Math.max(right - left, bottom - top, 1e-9);
  const shown = ([x, y]: Place): string => `${((x - left) * scale).toFixed(1)} ${((y - top) * scale).toFixed(1)}`;
  const isInside = ([x, y]: Place): boolean => x >= left && x <= right && y >= top && y <= bottom;
  const cameras = views.map((view) =>
    outlineOf(view, CAMERA / scale)
      .map((line) => `M${line.map((corner) => shown(flat(...corner))).join('L')}`)
      .join(''),
  );
  const margin = ball === null ? MARGIN : -CROP;
  const box = [-margin, -margin, (right - left) * scale + 2 * margin, (bottom - top) * scale + 2 * margin];
  return {
    viewBox: box.map((x) => x.toFixed(0)).join(' '),
    mesh: places
      .filter(isInside)
      .map((place) => `M${shown(place)}h0`)
      .join(''),
    cameras,
  };
}

/** A ball around cameras and nearly all points of a mesh; meters. */
export interface Ball {
  readonly center: Point;
  readonly radius: number;
}

/** The ball that a picture shows from all sides, so that its scale stays while it turns. */
export function ballAround(surface: ArrayLike<number>, views: readonly CaptureView[]): Ball {
  const points = Array.from({ length: surface.length / 3 }, (_, i) => [0, 1, 2].map((axis) => surface[3 * i + axis] ?? 0));
  const cameras = views.map(({ worldFromCamera: m }) => [m[12] ?? 0, m[13] ?? 0, m[14] ?? 0]);
  const ranges = [0, 1, 2].map((axis) => rangeOf(points, cameras, axis));
  const [x = 0, y = 0, z = 0] = ranges.map(([least, most]) => (least + most) / 2);
  return { center: [x, y, z], radius: Math.max(Math.hypot(...ranges.map(([least, most]) => most - least)) / 2, 1e-9) };
}

function around([x, y]: Place, radius: number): Frame {
  return { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius };
}

function centersOf(views: readonly CaptureView[], flat: (...point: Point) => Place): readonly Place[] {
  return views.map(({ worldFromCamera: m }) => flat(m[12] ?? 0, m[13] ?? 0, m[14] ?? 0));
}

function fitted(places: readonly Place[], cameras: readonly Place[]): Frame {
  const [left, right] = rangeOf(places, cameras, 0);
  const [top, bottom] = rangeOf(places, cameras, 1);
  return { left, top, right, bottom };
}

/** Least and most of a coordinate over all cameras and nearly all points. */
function rangeOf(points: readonly (readonly number[])[], cameras: readonly (readonly number[])[], axis: number): Place {
  const sorted = Float64Array.from(points, (point) => point[axis] ?? 0).sort();
  const stray = Math.floor(STRAY * sorted.length);
  const ends = [...cameras.map((point) => point[axis] ?? 0), ...[sorted[stray], sorted[sorted.length - 1 - stray]].flatMap((x) => x ?? [])];
  return [Math.min(...ends), Math.max(...ends)];
}

/** The lines of a camera that is `length` long: a pyramid towards what it sees, whose upper edge has a tip; a diamond for a 360° camera. */
function outlineOf({ projection, worldFromCamera: m, widthPx, heightPx, fxPx, fyPx, cxPx, cyPx }: CaptureView, length: number): Point[][] {
  const at = (x: number, y: number, z: number): Point => {
    const along = (row: number): number => (m[row] ?? 0) * x + (m[4 + row] ?? 0) * y + (m[8 + row] ?? 0) * z + (m[12 + row] ?? 0);
    return [along(0), along(1), along(2)];
  };
  if (projection !== undefined) {
    const [r, l] = [length / 3, -length / 3];
    return [
      [at(r, 0, 0), at(0, r, 0), at(l, 0, 0), at(0, l, 0), at(r, 0, 0)],
      [at(r, 0, 0), at(0, 0, r), at(l, 0, 0), at(0, 0, l), at(r, 0, 0)],
    ];
  }
  const corner = (column: number, row: number): Point => at((length * (column - cxPx)) / fxPx, (-length * (row - cyPx)) / fyPx, -length);
  const [a, b, c, d] = [corner(0, 0), corner(widthPx, 0), corner(widthPx, heightPx), corner(0, heightPx)];
  const eye = at(0, 0, 0);
  return [
    [a, b, c, d, a],
    [b, eye, a],
    [d, eye, c],
    [a, corner(widthPx / 2, -heightPx / 4), b],
  ];
}
