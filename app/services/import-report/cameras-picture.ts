import { sampleSurface } from '../../../export/captures/points/sample-surface.ts';
import type { CaptureDocument, CaptureMesh, CaptureView } from '../../../nodes/kit/capture.ts';
import { text } from '../report-html.ts';

type Point = readonly [number, number, number];

/** A direction of view by the world axes that point to the right and up in the picture. */
interface Side {
  readonly caption: string;
  readonly right: Point;
  readonly up: Point;
}

const [YAW, PITCH] = [0.6, 0.55];
const SIDES: readonly Side[] = [
  { caption: 'From above', right: [1, 0, 0], up: [0, 0, -1] },
  { caption: 'From the front', right: [1, 0, 0], up: [0, 1, 0] },
  {
    caption: 'At an angle',
    right: [Math.cos(YAW), 0, -Math.sin(YAW)],
    up: [-Math.sin(YAW) * Math.sin(PITCH), Math.cos(PITCH), -Math.cos(YAW) * Math.sin(PITCH)],
  },
];
const POINTS = 6000;
/** Width and height of a picture in units of SVG, without its margin. */
const SIZE = 1000;
const MARGIN = 60;
/** Length of a drawn camera. */
const CAMERA = 55;
/** The share of points beyond each edge, which are left out: reconstructions have stray triangles far away. */
const STRAY = 0.005;

/** Pictures of the cameras over the mesh, from three sides, as figures of HTML. `names` are those of the photographs. */
export function camerasPictures({ views }: CaptureDocument, mesh: CaptureMesh, names: readonly string[]): string {
  const points = sampleSurface(mesh, POINTS);
  return SIDES.map((side) => picture(side, points, views, names)).join('\n');
}

function picture({ caption, right, up }: Side, points: Float32Array, views: readonly CaptureView[], names: readonly string[]): string {
  const flat = (x: number, y: number, z: number): readonly [number, number] => [
    x * right[0] + y * right[1] + z * right[2],
    -(x * up[0] + y * up[1] + z * up[2]),
  ];
  const places = Array.from({ length: points.length / 3 }, (_, i) =>
    flat(points[3 * i] ?? 0, points[3 * i + 1] ?? 0, points[3 * i + 2] ?? 0),
  );
  const cameras = views.map(({ worldFromCamera: m }) => flat(m[12] ?? 0, m[13] ?? 0, m[14] ?? 0));
  const [left, most] = rangeOf(places, cameras, 0);
  const [top, bottom] = rangeOf(places, cameras, 1);
  const scale = SIZE / Math.max(most - left, bottom - top, 1e-9);
  const shown = ([x, y]: readonly [number, number]): string => `${((x - left) * scale).toFixed(1)} ${((y - top) * scale).toFixed(1)}`;
  const isInside = ([x, y]: readonly [number, number]): boolean => x >= left && x <= most && y >= top && y <= bottom;
  const dots = places.filter(isInside).map((place) => `M${shown(place)}h0`);
  const drawn = views.map((view, i) => {
    const lines = outlineOf(view, CAMERA / scale).map((line) => `M${line.map((corner) => shown(flat(...corner))).join('L')}`);
    return `<path class="camera" d="${lines.join('')}"><title>${text(names[i] ?? '')}</title></path>`;
  });
  const box = [-MARGIN, -MARGIN, (most - left) * scale + 2 * MARGIN, (bottom - top) * scale + 2 * MARGIN].map((x) => x.toFixed(0));
  return `<figure><svg viewBox="${box.join(' ')}" role="img" aria-label="${caption}"><path class="mesh" d="${dots.join('')}"/>${drawn.join('')}</svg><figcaption>${caption}</figcaption></figure>`;
}

/** Least and most of a coordinate over all cameras and nearly all points. */
function rangeOf(places: readonly (readonly [number, number])[], cameras: readonly (readonly [number, number])[], axis: 0 | 1) {
  const sorted = Float64Array.from(places, (place) => place[axis]).sort();
  const own = cameras.map((place) => place[axis]);
  const stray = Math.floor(STRAY * sorted.length);
  const ends = [...own, ...[sorted[stray], sorted[sorted.length - 1 - stray]].flatMap((x) => x ?? [])];
  return [Math.min(...ends), Math.max(...ends)] as const;
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
    [a, eye, b],
    [c, eye, d],
    [a, corner(widthPx / 2, -heightPx / 4), b],
  ];
}
