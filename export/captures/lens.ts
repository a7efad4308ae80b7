import { CaptureError, type Pinhole } from '../../nodes/kit/capture.ts';

/**
 * A camera as photogrammetry describes it, in OpenCV's terms: pixels, y down, camera axes x right, y down, z forward. `radial` are k1 to k6
 * (perspective: k4 to k6 divide) or k1 to k4 (fisheye); `tangential` are p1 and p2. An equirectangular lens has pixels per radian in the
 * place of focal lengths, and its directions are longitude and latitude, downward, in radians.
 */
export interface Lens extends Omit<Pinhole, 'projection'> {
  readonly projection: 'perspective' | 'fisheye' | 'equirectangular';
  readonly radial: readonly number[];
  readonly tangential: readonly [number, number];
}

type Params = readonly number[];
type Described = Omit<Lens, 'widthPx' | 'heightPx'>;

interface Model {
  readonly id: number;
  readonly params: number;
  read(p: Params): Described;
}

const PLAIN = { projection: 'perspective', radial: [], tangential: [0, 0] } as const;

function oneFocus([f = 0, cx = 0, cy = 0]: Params) {
  return { fxPx: f, fyPx: f, cxPx: cx, cyPx: cy };
}

function twoFoci([fx = 0, fy = 0, cx = 0, cy = 0]: Params) {
  return { fxPx: fx, fyPx: fy, cxPx: cx, cyPx: cy };
}

/** The camera models of COLMAP (src/colmap/sensor/models.h) that can be imported. */
const MODELS: Readonly<Record<string, Model>> = {
  SIMPLE_PINHOLE: { id: 0, params: 3, read: (p) => ({ ...PLAIN, ...oneFocus(p) }) },
  PINHOLE: { id: 1, params: 4, read: (p) => ({ ...PLAIN, ...twoFoci(p) }) },
  SIMPLE_RADIAL: { id: 2, params: 4, read: (p) => ({ ...PLAIN, ...oneFocus(p), radial: p.slice(3) }) },
  RADIAL: { id: 3, params: 5, read: (p) => ({ ...PLAIN, ...oneFocus(p), radial: p.slice(3) }) },
  OPENCV: { id: 4, params: 8, read: (p) => ({ ...PLAIN, ...twoFoci(p), radial: p.slice(4, 6), tangential: [p[6] ?? 0, p[7] ?? 0] }) },
  OPENCV_FISHEYE: { id: 5, params: 8, read: (p) => ({ ...PLAIN, ...twoFoci(p), projection: 'fisheye', radial: p.slice(4) }) },
  FULL_OPENCV: {
    id: 6,
    params: 12,
    read: (p) => ({ ...PLAIN, ...twoFoci(p), radial: [...p.slice(4, 6), ...p.slice(8)], tangential: [p[6] ?? 0, p[7] ?? 0] }),
  },
};

/** The camera models that are refused by name, by their number in binary files. */
const REFUSED: Readonly<Record<number, string>> = {
  7: 'FOV',
  8: 'SIMPLE_RADIAL_FISHEYE',
  9: 'RADIAL_FISHEYE',
  10: 'THIN_PRISM_FISHEYE',
  11: 'RAD_TAN_THIN_PRISM_FISHEYE',
  12: 'SIMPLE_DIVISION',
  13: 'DIVISION',
  14: 'SIMPLE_FISHEYE',
  15: 'FISHEYE',
  16: 'EUCM',
  17: 'EQUIRECTANGULAR',
};

/**
 * The lens of a 360° photograph, whose center is straight ahead.
 *
 * @throws CaptureError if it is not twice as wide as high.
 */
export function equirectangularLens(widthPx: number, heightPx: number, name: string): Lens {
  if (widthPx !== 2 * heightPx) {
    throw new CaptureError(`the photograph ${name} is ${widthPx} × ${heightPx} pixels, but a 360° photograph is twice as wide as high`);
  }
  const perRadian = heightPx / Math.PI;
  const center = { cxPx: widthPx / 2, cyPx: heightPx / 2 };
  return { ...PLAIN, projection: 'equirectangular', widthPx, heightPx, fxPx: perRadian, fyPx: perRadian, ...center };
}

/** The name of a camera model of a binary file, and its number of params. */
export function modelOfId(id: number): { readonly name: string; readonly params: number } {
  const [name, model] = Object.entries(MODELS).find(([, { id: known }]) => known === id) ?? [];
  if (name === undefined || !model) throw unknownModel(REFUSED[id] ?? `number ${id}`);
  return { name, params: model.params };
}

/**
 * A lens from a camera model of COLMAP.
 *
 * @throws CaptureError for other models, and for params that no camera has.
 */
export function lensOf(name: string, widthPx: number, heightPx: number, params: Params): Lens {
  const model = Object.hasOwn(MODELS, name) ? MODELS[name] : undefined;
  if (!model) throw unknownModel(name);
  if (params.length !== model.params) throw new CaptureError(`a camera ${name} has ${params.length} params instead of ${model.params}`);
  return checkLens({ ...model.read(params), widthPx, heightPx });
}

/** @throws CaptureError for a lens that cannot be one. */
export function checkLens(lens: Lens): Lens {
  const { widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, radial, tangential } = lens;
  if (![widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, ...radial, ...tangential].every(Number.isFinite)) {
    throw new CaptureError('a number of a camera is not finite');
  }
  if (fxPx <= 0 || fyPx <= 0) throw new CaptureError('the focal length of a camera is not above 0');
  if (widthPx < 1 || heightPx < 1) throw new CaptureError('a camera has no size');
  return lens;
}

function unknownModel(name: string): CaptureError {
  return new CaptureError(
    `the camera model ${name} is not supported, only ${Object.keys(MODELS).join(', ')}. Undistort the photographs with COLMAP first`,
  );
}

/** Whether the lens bends lines. */
export function isDistorted({ projection, radial, tangential }: Lens): boolean {
  return projection === 'fisheye' || [...radial, ...tangential].some((k) => k !== 0);
}

/**
 * Where a direction lands in the photograph.
 *
 * @param x Direction in camera space over its depth; `y` too, down.
 * @param out Receives column and row in pixels.
 */
export function project({ projection, fxPx, fyPx, cxPx, cyPx, radial, tangential }: Lens, x: number, y: number, out: Float64Array): void {
  const r2 = x * x + y * y;
  // By index: taking lists apart makes an iterator per call.
  const k1 = radial[0] ?? 0;
  const k2 = radial[1] ?? 0;
  const k3 = radial[2] ?? 0;
  const k4 = radial[3] ?? 0;
  const k5 = radial[4] ?? 0;
  const k6 = radial[5] ?? 0;
  let px = x;
  let py = y;
  if (projection === 'fisheye') {
    const r = Math.sqrt(r2);
    const theta = Math.atan(r);
    const t2 = theta * theta;
    const scale = r > 1e-9 ? (theta * (1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))))) / r : 1;
    px = x * scale;
    py = y * scale;
  } else {
    const scale = (1 + r2 * (k1 + r2 * (k2 + r2 * k3))) / (1 + r2 * (k4 + r2 * (k5 + r2 * k6)));
    const p1 = tangential[0];
    const p2 = tangential[1];
    px = x * scale + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
    py = y * scale + 2 * p2 * x * y + p1 * (r2 + 2 * y * y);
  }
  out[0] = fxPx * px + cxPx;
  out[1] = fyPx * py + cyPx;
}

const STEP = 1e-6;
const MAX_ITERATIONS = 50;

/**
 * The direction that lands at a place of the photograph, by Newton's method.
 *
 * @param out Receives x and y of the direction over its depth; NaN where there is none.
 */
export function unproject(lens: Lens, column: number, row: number, out: Float64Array): void {
  let x = (column - lens.cxPx) / lens.fxPx;
  let y = (row - lens.cyPx) / lens.fyPx;
  if (lens.projection === 'fisheye') {
    const theta = Math.min(Math.hypot(x, y), 1.5);
    const scale = theta > 1e-9 ? Math.tan(theta) / theta : 1;
    x *= scale;
    y *= scale;
  }
  for (let i = 0; i < MAX_ITERATIONS; i++) {
    project(lens, x, y, out);
    const [u = 0, v = 0] = out;
    if (Math.hypot(u - column, v - row) < 1e-7) break;
    project(lens, x + STEP, y, out);
    const ux = ((out[0] ?? 0) - u) / STEP;
    const vx = ((out[1] ?? 0) - v) / STEP;
    project(lens, x, y + STEP, out);
    const uy = ((out[0] ?? 0) - u) / STEP;
    const vy = ((out[1] ?? 0) - v) / STEP;
    const determinant = ux * vy - uy * vx;
    x -= (vy * (u - column) - uy * (v - row)) / determinant;
    y -= (ux * (v - row) - vx * (u - column)) / determinant;
  }
  project(lens, x, y, out);
  const isFound = Math.hypot((out[0] ?? 0) - column, (out[1] ?? 0) - row) < 1e-3;
  out[0] = isFound ? x : Number.NaN;
  out[1] = isFound ? y : Number.NaN;
}
