/**
 * How a depth buffer lies against its view. Coordinates are normalized with the origin at the top left and y down, for view and
 * buffer alike (WebXR Depth Sensing §1.1). First the covered rectangle, then the flips, then the turn.
 */
export interface DepthTransform {
  /** Clockwise turn of the buffer's picture against the view's: 90 is a phone's sensor when the phone stands upright. */
  readonly turnDeg?: 0 | 90 | 180 | 270;
  readonly flipX?: boolean;
  readonly flipY?: boolean;
  /** The rectangle of the view that the buffer shows; larger than the view (from below 0 to above 1) when the sensor sees more. */
  readonly covers?: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
}

/** u' = a·u + c·v + tx, v' = b·u + d·v + ty */
export interface Affine {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
  readonly tx: number;
  readonly ty: number;
}

const IDENTITY: Affine = { a: 1, b: 0, c: 0, d: 1, tx: 0, ty: 0 };
const FLIP_X: Affine = { ...IDENTITY, a: -1, tx: 1 };
const FLIP_Y: Affine = { ...IDENTITY, d: -1, ty: 1 };
/** What was on the right comes to the bottom: (u, v) → (1 − v, u). */
const QUARTER: Affine = { a: 0, b: 1, c: -1, d: 0, tx: 1, ty: 0 };

/** `normDepthBufferFromNormView` as a map of the plane. */
export function depthUvFromViewUv(transform: DepthTransform): Affine {
  const covers = transform.covers ?? { x: 0, y: 0, width: 1, height: 1 };
  const parts: Affine[] = [
    { a: 1 / covers.width, b: 0, c: 0, d: 1 / covers.height, tx: -covers.x / covers.width, ty: -covers.y / covers.height },
  ];
  if (transform.flipX) parts.push(FLIP_X);
  if (transform.flipY) parts.push(FLIP_Y);
  for (let turned = 0; turned < (transform.turnDeg ?? 0); turned += 90) parts.push(QUARTER);
  return parts.reduce((first, then) => compose(then, first), IDENTITY);
}

/** Column-major 4×4 that leaves z alone, as the specification asks. */
export function affineToMatrix({ a, b, c, d, tx, ty }: Affine): Float32Array {
  return new Float32Array([a, b, 0, 0, c, d, 0, 0, 0, 0, 1, 0, tx, ty, 0, 1]);
}

/**
 * The projection to draw a depth buffer with: `clipFromView` followed by the map in normalized coordinates. Row 0 of the drawn
 * target is the buffer's top row, so reading it back needs no turning over.
 *
 * @param clipFromView Column-major 4×4.
 */
export function depthClipFromView(clipFromView: ArrayLike<number>, map: Affine): Float32Array {
  // Normalized device coordinates to view UV and depth UV to the target's device coordinates: x = 2u − 1, y = 1 − 2v before,
  // y = 2v − 1 after.
  const ax = map.a;
  const ay = -map.c;
  const ac = map.a + map.c + 2 * map.tx - 1;
  const bx = map.b;
  const by = -map.d;
  const bc = map.b + map.d + 2 * map.ty - 1;
  const out = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    const at = (row: number): number => clipFromView[column * 4 + row] ?? 0;
    out[column * 4] = ax * at(0) + ay * at(1) + ac * at(3);
    out[column * 4 + 1] = bx * at(0) + by * at(1) + bc * at(3);
    out[column * 4 + 2] = at(2);
    out[column * 4 + 3] = at(3);
  }
  return out;
}

function compose(then: Affine, first: Affine): Affine {
  return {
    a: then.a * first.a + then.c * first.b,
    b: then.b * first.a + then.d * first.b,
    c: then.a * first.c + then.c * first.d,
    d: then.b * first.c + then.d * first.d,
    tx: then.a * first.tx + then.c * first.ty + then.tx,
    ty: then.b * first.tx + then.d * first.ty + then.ty,
  };
}
