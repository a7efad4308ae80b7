/**
 * Orientation of a depth buffer relative to its view. Coordinates of both are normalized, with the origin at the top left and y down (WebXR
 * Depth Sensing §1.1). The steps apply in this order: `covers`, flips, rotation.
 */
export interface DepthTransform {
  /** Clockwise rotation of the buffer relative to the view. A phone held upright has 90. */
  readonly turnDeg?: 0 | 90 | 180 | 270;
  readonly flipX?: boolean;
  readonly flipY?: boolean;
  /** Rectangle of the view that the buffer covers. It exceeds [0, 1] if the sensor sees more than the view. */
  readonly covers?: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
}

/** An affine map of UV coordinates: u' = a·u + c·v + tx, v' = b·u + d·v + ty */
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
/** Clockwise quarter turn: (u, v) → (1 − v, u). */
const QUARTER: Affine = { a: 0, b: 1, c: -1, d: 0, tx: 1, ty: 0 };

/**
 * Affine map of `normDepthBufferFromNormView`.
 *
 * @returns Depth buffer UV from view UV; both have their origin at the top left.
 */
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

/** Converts the map to a column-major 4×4 matrix that leaves z unchanged, as the specification requires. */
export function affineToMatrix({ a, b, c, d, tx, ty }: Affine): Float32Array {
  return new Float32Array([a, b, 0, 0, c, d, 0, 0, 0, 0, 1, 0, tx, ty, 0, 1]);
}

/**
 * Projection for rendering a depth buffer: `clipFromView` followed by `map`. Row 0 of the target is the top row of the buffer, so its
 * pixels need no flip after readback.
 *
 * @param clipFromView Column-major 4×4.
 * @param map Depth buffer UV from view UV.
 */
export function depthClipFromView(clipFromView: ArrayLike<number>, map: Affine): Float32Array {
  // x = 2u − 1, y = 1 − 2v converts view UV to device coordinates; y = 2v − 1 for the target, whose rows are flipped.
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
