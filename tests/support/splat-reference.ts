import type { SplatPoint } from '../../tools/examples/splats/write-sog.ts';

/**
 * A rasterizer of Gaussian splats in double precision, by the formulas of Kerbl et al. 2023, pixel by pixel and from front to back: the
 * measure of the renderer. It shares nothing with it.
 */
export interface ReferenceView {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 4×4. */
  readonly clipFromView: ArrayLike<number>;
  readonly viewFromWorld: ArrayLike<number>;
  readonly eyeWorld: readonly [number, number, number];
  /** Standard deviations at which splats end. Default: where alpha falls below 1/255, as in Kerbl et al. */
  readonly endsAt?: number;
}

interface Projected {
  readonly z: number;
  readonly x: number;
  readonly y: number;
  /** Inverse of the covariance on the screen: xx, xy, yy. */
  readonly conic: readonly [number, number, number];
  /** Beyond this distance along x and y alpha is below 1/255: four standard deviations, pixels. */
  readonly reach: readonly [number, number];
  readonly color: readonly number[];
  readonly opacity: number;
}

/** Premultiplied RGBA in [0, 255], rows from the bottom. */
export function rasterize(splats: readonly SplatPoint[], view: ReferenceView): Float64Array {
  const { widthPx, heightPx, endsAt } = view;
  const projected = splats
    .flatMap((splat) => project(splat, view) ?? [])
    .map((splat, index) => ({ splat, index }))
    .sort((a, b) => a.splat.z - b.splat.z || b.index - a.index)
    .map(({ splat }) => splat);
  const pixels = new Float64Array(4 * widthPx * heightPx);
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      let through = 1;
      const at = 4 * (row * widthPx + column);
      for (const { x, y, conic, reach, color, opacity } of projected) {
        const dx = column + 0.5 - x;
        const dy = row + 0.5 - y;
        if (Math.abs(dx) > reach[0] || Math.abs(dy) > reach[1]) continue;
        const power = -0.5 * (conic[0] * dx * dx + conic[2] * dy * dy) - conic[1] * dx * dy;
        const alpha = Math.min(0.99, opacity * Math.exp(power));
        if (endsAt === undefined ? alpha < 1 / 255 : power < -0.5 * endsAt ** 2) continue;
        for (let c = 0; c < 3; c++) pixels[at + c] = (pixels[at + c] ?? 0) + 255 * through * alpha * Math.min(1, color[c] ?? 0);
        through *= 1 - alpha;
      }
      pixels[at + 3] = 255 * (1 - through);
    }
  }
  return pixels;
}

function project(splat: SplatPoint, { widthPx, heightPx, clipFromView: p, viewFromWorld: v, eyeWorld }: ReferenceView): Projected | null {
  const at = (matrix: ArrayLike<number>, row: number, column: number): number => matrix[4 * column + row] ?? 0;
  const [px, py, pz] = splat.position;
  const toView = (row: number): number => at(v, row, 0) * px + at(v, row, 1) * py + at(v, row, 2) * pz + at(v, row, 3);
  const [X, Y, Z] = [toView(0), toView(1), toView(2)];
  if (-Z < 0.2) return null;
  // The covariance in world space: R S S R^T.
  const rotation = matrixOf(splat.rotation);
  const world = [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) =>
      [0, 1, 2].reduce((sum, k) => sum + (rotation[i]?.[k] ?? 0) * (splat.scale[k] ?? 0) ** 2 * (rotation[j]?.[k] ?? 0), 0),
    ),
  );
  const fx = (at(p, 0, 0) * widthPx) / 2;
  const fy = (at(p, 1, 1) * heightPx) / 2;
  const clamped = (value: number, scale: number): number => Math.max(-1.3 / scale, Math.min(1.3 / scale, value));
  const sx = clamped(X / -Z, at(p, 0, 0));
  const sy = clamped(Y / -Z, at(p, 1, 1));
  const jacobian = [
    [fx / -Z, 0, (fx * sx) / -Z],
    [0, fy / -Z, (fy * sy) / -Z],
  ];
  // J W, where W is the rotation of the view.
  const t = jacobian.map((row) => [0, 1, 2].map((column) => row.reduce((sum, value, k) => sum + value * at(v, k, column), 0)));
  const cov = (a: number, b: number): number =>
    [0, 1, 2].reduce((sum, i) => sum + [0, 1, 2].reduce((s, j) => s + (t[a]?.[i] ?? 0) * (world[i]?.[j] ?? 0) * (t[b]?.[j] ?? 0), 0), 0);
  const [xx, xy, yy] = [cov(0, 0) + 0.3, cov(0, 1), cov(1, 1) + 0.3];
  const determinant = xx * yy - xy * xy;
  return {
    z: -Z,
    x: ((at(p, 0, 0) * X) / -Z / 2 + 0.5) * widthPx,
    y: ((at(p, 1, 1) * Y) / -Z / 2 + 0.5) * heightPx,
    conic: [yy / determinant, -xy / determinant, xx / determinant],
    reach: [4 * Math.sqrt(xx), 4 * Math.sqrt(yy)],
    color: colorFrom(splat, eyeWorld),
    opacity: splat.opacity,
  };
}

function matrixOf([x, y, z, w]: SplatPoint['rotation']): number[][] {
  const n = Math.hypot(x, y, z, w) ** 2;
  return [
    [1 - (2 * (y * y + z * z)) / n, (2 * (x * y - w * z)) / n, (2 * (x * z + w * y)) / n],
    [(2 * (x * y + w * z)) / n, 1 - (2 * (x * x + z * z)) / n, (2 * (y * z - w * x)) / n],
    [(2 * (x * z - w * y)) / n, (2 * (y * z + w * x)) / n, 1 - (2 * (x * x + y * y)) / n],
  ];
}

/** Real spherical harmonics from their normalization constants, with the signs of Kerbl et al. */
export function colorFrom({ position, color, harmonics = [] }: SplatPoint, eye: readonly [number, number, number]): number[] {
  const away = position.map((value, axis) => value - (eye[axis] ?? 0));
  const length = Math.hypot(...away);
  const [x = 0, y = 0, z = 0] = away.map((value) => value / length);
  const { PI, sqrt } = Math;
  const basis = [
    ...[-y, z, -x].map((value) => sqrt(3 / (4 * PI)) * value),
    ...[x * y, -y * z].map((value) => sqrt(15 / (4 * PI)) * value),
    sqrt(5 / (16 * PI)) * (3 * z * z - 1),
    -sqrt(15 / (4 * PI)) * x * z,
    sqrt(15 / (16 * PI)) * (x * x - y * y),
    -sqrt(35 / (32 * PI)) * y * (3 * x * x - y * y),
    sqrt(105 / (4 * PI)) * x * y * z,
    -sqrt(21 / (32 * PI)) * y * (5 * z * z - 1),
    sqrt(7 / (16 * PI)) * z * (5 * z * z - 3),
    -sqrt(21 / (32 * PI)) * x * (5 * z * z - 1),
    sqrt(105 / (16 * PI)) * z * (x * x - y * y),
    -sqrt(35 / (32 * PI)) * x * (x * x - 3 * y * y),
  ];
  return color.map((value, c) =>
    Math.max(
      0,
      basis.reduce((sum, b, i) => sum + b * (harmonics[3 * i + c] ?? 0), value),
    ),
  );
}
