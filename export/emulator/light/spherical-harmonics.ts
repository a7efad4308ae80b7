/** A square image along one axis of the world with a field of view of 90°: linear-sRGB radiance, RGBA, rows from the bottom. */
export interface CubeFace {
  readonly rgba: Float32Array;
  /** Axes of the camera, unit vectors in world space. */
  readonly forward: Vector;
  readonly right: Vector;
  readonly up: Vector;
}

type Vector = readonly [number, number, number];

/**
 * Projects six square faces of `sizePx` on the real basis functions, each texel weighted by its solid angle (Ramamoorthi and Hanrahan 2001,
 * eq. 3). Returns 9 coefficients × RGB in the order of WebXR Lighting Estimation §3.2.
 */
export function projectCube(faces: readonly CubeFace[], sizePx: number): Float32Array {
  const out = new Float64Array(27);
  const basis = new Float64Array(9);
  for (const { rgba, forward, right, up } of faces) {
    for (let row = 0; row < sizePx; row++) {
      for (let column = 0; column < sizePx; column++) {
        const s = (2 * (column + 0.5)) / sizePx - 1;
        const t = (2 * (row + 0.5)) / sizePx - 1;
        const distance = Math.hypot(1, s, t);
        const solidAngle = 4 / (sizePx * sizePx) / distance ** 3;
        const along = (axis: 0 | 1 | 2): number => (forward[axis] + s * right[axis] + t * up[axis]) / distance;
        evaluateBasis(along(0), along(1), along(2), basis);
        const texel = (row * sizePx + column) * 4;
        for (let k = 0; k < 27; k++) {
          const radiance = rgba[texel + (k % 3)] ?? 0;
          out[k] = (out[k] ?? 0) + radiance * (basis[Math.floor(k / 3)] ?? 0) * solidAngle;
        }
      }
    }
  }
  return Float32Array.from(out);
}

/** The nine real basis functions of a unit direction, bands 0 to 2. */
export function evaluateBasis(x: number, y: number, z: number, out: Float64Array): void {
  out[0] = 0.282094791773878;
  out[1] = 0.488602511902919 * y;
  out[2] = 0.488602511902919 * z;
  out[3] = 0.488602511902919 * x;
  out[4] = 1.092548430592079 * x * y;
  out[5] = 1.092548430592079 * y * z;
  out[6] = 0.31539156525252 * (3 * z * z - 1);
  out[7] = 1.092548430592079 * x * z;
  out[8] = 0.5462742152960395 * (x * x - y * y);
}
