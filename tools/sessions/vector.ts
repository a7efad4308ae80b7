export type Vector = readonly [number, number, number];
/** Column-major 4×4. */
export type Matrix = readonly number[];

export function add(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vector, factor: number): Vector {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function normalize(a: Vector): Vector {
  return scale(a, 1 / Math.sqrt(dot(a, a)));
}

export function transformPoint(m: Matrix, [x, y, z]: Vector): Vector {
  const row = (r: number): number => (m[r] ?? 0) * x + (m[r + 4] ?? 0) * y + (m[r + 8] ?? 0) * z + (m[r + 12] ?? 0);
  return [row(0), row(1), row(2)];
}

export function transformDirection(m: Matrix, [x, y, z]: Vector): Vector {
  const row = (r: number): number => (m[r] ?? 0) * x + (m[r + 4] ?? 0) * y + (m[r + 8] ?? 0) * z;
  return [row(0), row(1), row(2)];
}

export function multiply(a: Matrix, b: Matrix): Matrix {
  const out: number[] = [];
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += (a[k * 4 + row] ?? 0) * (b[column * 4 + k] ?? 0);
      out.push(sum);
    }
  }
  return out;
}

/** The matrix with these images of the axes and of the origin. */
export function fromAxes(x: Vector, y: Vector, z: Vector, origin: Vector): Matrix {
  return [...x, 0, ...y, 0, ...z, 0, ...origin, 1];
}

/** Inverts a rotation and translation. */
export function invertRigid(m: Matrix): Matrix {
  const axis = (column: number): Vector => [m[column * 4] ?? 0, m[column * 4 + 1] ?? 0, m[column * 4 + 2] ?? 0];
  const [x, y, z, origin] = [axis(0), axis(1), axis(2), axis(3)];
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, origin), -dot(y, origin), -dot(z, origin), 1];
}
