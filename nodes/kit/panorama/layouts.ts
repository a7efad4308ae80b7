/**
 * How an image shows all directions. `ball`: a photo of a mirror ball, cut to the ball. The cube layouts have six square faces:
 * `cross` 4 × 3 and `cross-upright` 3 × 4 faces, `strip` 6 × 1 and `strip-upright` 1 × 6.
 */
export type PanoramaLayout = 'equirectangular' | 'ball' | 'cross' | 'cross-upright' | 'strip' | 'strip-upright';

/** The layouts with their aspect ratios, width over height. */
const ASPECTS: readonly (readonly [aspect: number, layout: PanoramaLayout])[] = [
  [2, 'equirectangular'],
  [1, 'ball'],
  [4 / 3, 'cross'],
  [3 / 4, 'cross-upright'],
  [6, 'strip'],
  [1 / 6, 'strip-upright'],
];
/** Tolerance of the aspect ratio: exported images are sometimes a few pixels off. */
const TOLERANCE = 0.015;
/**
 * The layout of an image by its shape.
 *
 * @returns Null for a shape that none has.
 *
 * @example
 * layoutOf(4096, 2048); // 'equirectangular'
 */
export function layoutOf(widthPx: number, heightPx: number): PanoramaLayout | null {
  const aspect = widthPx / heightPx;
  return ASPECTS.find(([wanted]) => Math.abs(aspect / wanted - 1) <= TOLERANCE)?.[1] ?? null;
}

/**
 * Describes what to do with an image whose shape is that of no panorama, as a sentence for users.
 *
 * @example
 * if (layoutOf(widthPx, heightPx) === null) throw new Error(wrongShape(widthPx, heightPx));
 */
export function wrongShape(widthPx: number, heightPx: number): string {
  const size = `It has ${widthPx} × ${heightPx} pixels`;
  const wanted =
    'A panorama is twice as wide as high; a photo of a mirror ball is square; six faces of a cube are a cross (4 : 3 or 3 : 4) or a strip (6 : 1 or 1 : 6)';
  if (widthPx > heightPx * 2) {
    return `${size}, so top and bottom are missing. Add them in an image editor until it is twice as wide as high: ${widthPx} × ${Math.round(widthPx / 2)}.`;
  }
  return `${size}, and none of the known shapes. ${wanted}. Crop or export it again.`;
}

/** A point of an image to sample: `x` and `y` from the upper left; pixel centers are at halves. */
export interface ImagePoint {
  x: number;
  y: number;
  /** The rectangle that interpolation may read, as edges in pixels, so that the faces of a cube do not mix. */
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/**
 * For each face of a cube, its column and row in the image, and whether it is rotated by 180°. Faces are named by the direction that they
 * show.
 */
type Faces = Readonly<Record<'px' | 'nx' | 'py' | 'ny' | 'pz' | 'nz', readonly [column: number, row: number, turned?: true]>>;

/**
 * Where each layout has the faces, as seen from inside the cube: the arms of a cross show left (−x), ahead (−z), right (+x) and behind
 * (+z), in this order.
 */
const CUBES: Readonly<Record<Exclude<PanoramaLayout, 'equirectangular' | 'ball'>, Faces>> = {
  cross: { nx: [0, 1], nz: [1, 1], px: [2, 1], pz: [3, 1], py: [1, 0], ny: [1, 2] },
  // The lowest face is behind, upside down, as HDR Shop writes it.
  'cross-upright': { nx: [0, 1], nz: [1, 1], px: [2, 1], pz: [1, 3, true], py: [1, 0], ny: [1, 2] },
  // Right, left, top, bottom, front, back: the order of sky boxes and of OpenGL.
  strip: { px: [0, 0], nx: [1, 0], py: [2, 0], ny: [3, 0], nz: [4, 0], pz: [5, 0] },
  'strip-upright': { px: [0, 0], nx: [0, 1], py: [0, 2], ny: [0, 3], nz: [0, 4], pz: [0, 5] },
};

/** The number of columns and rows of faces in each layout. */
const GRIDS: Readonly<Record<keyof typeof CUBES, readonly [columns: number, rows: number]>> = {
  cross: [4, 3],
  'cross-upright': [3, 4],
  strip: [6, 1],
  'strip-upright': [1, 6],
};

/**
 * Writes the point of an image at which it shows a direction of panorama space.
 *
 * @example
 * placeOf(point, 'ball', 512, 512, 0, 0, -1); // on the rim
 */
export function placeOf(out: ImagePoint, layout: PanoramaLayout, widthPx: number, heightPx: number, x: number, y: number, z: number): void {
  out.left = 0;
  out.top = 0;
  out.right = widthPx;
  out.bottom = heightPx;
  if (layout === 'equirectangular') {
    out.x = (Math.atan2(x, -z) / (2 * Math.PI) + 0.5) * widthPx;
    out.y = (0.5 - Math.asin(Math.min(Math.max(y, -1), 1)) / Math.PI) * heightPx;
  } else if (layout === 'ball') placeOnBall(out, widthPx, heightPx, x, y, z);
  else placeOnFace(out, layout, widthPx, heightPx, x, y, z);
}

/**
 * Finds the point of a mirror ball that reflects a direction (Debevec 1998, “Rendering Synthetic Objects into Real Scenes”): the normal
 * there is halfway between the direction and the camera, which is far away in the direction +z. What is behind the ball is at its rim.
 */
function placeOnBall(out: ImagePoint, widthPx: number, heightPx: number, x: number, y: number, z: number): void {
  const length = Math.hypot(x, y, z + 1);
  out.x = (length > 1e-6 ? 0.5 + x / length / 2 : 0.5) * widthPx;
  out.y = (length > 1e-6 ? 0.5 - y / length / 2 : 0) * heightPx;
}

function placeOnFace(
  out: ImagePoint,
  layout: keyof typeof CUBES,
  widthPx: number,
  heightPx: number,
  x: number,
  y: number,
  z: number,
): void {
  const [columns, rows] = GRIDS[layout];
  const [sizeX, sizeY] = [widthPx / columns, heightPx / rows];
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const most = Math.max(ax, ay, az);
  // Right and down on the face, seen from inside.
  const [face, right, down] =
    most === az
      ? z < 0
        ? (['nz', x, -y] as const)
        : (['pz', -x, -y] as const)
      : most === ax
        ? x > 0
          ? (['px', z, -y] as const)
          : (['nx', -z, -y] as const)
        : y > 0
          ? (['py', x, -z] as const)
          : (['ny', x, z] as const);
  const [column, row, turned] = CUBES[layout][face];
  const sign = turned ? -1 : 1;
  out.left = column * sizeX;
  out.top = row * sizeY;
  out.right = out.left + sizeX;
  out.bottom = out.top + sizeY;
  out.x = out.left + (0.5 + (sign * right) / most / 2) * sizeX;
  out.y = out.top + (0.5 + (sign * down) / most / 2) * sizeY;
}
