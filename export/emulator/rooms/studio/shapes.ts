/** Triangles with vertex data: three numbers per vertex, two for `uvM`. */
export interface Shape {
  readonly positions: number[];
  readonly normals: number[];
  /** Distance along the surface in meters; the material converts it to texture coordinates. */
  readonly uvM: number[];
  readonly indices: number[];
}

type Triple = readonly [number, number, number];
type Axis = 0 | 1 | 2;

/** Longest edge of a flat surface, in meters, because light is baked per vertex. */
const STEP_M = 0.2;
/** Below this radius, in meters, a chamfer replaces the rounding. */
const SMALL_RADIUS_M = 0.03;

/** A box around the origin, its edges rounded; radius 0 keeps them sharp. */
export function roundedBox(size: Triple, radiusM = 0): Shape {
  const shape: Shape = { positions: [], normals: [], uvM: [], indices: [] };
  const half = size.map((s) => s / 2) as unknown as Triple;
  const inner = half.map((h) => Math.max(h - radiusM, 0)) as unknown as Triple;
  const faces: readonly (readonly [Axis, Axis, Axis])[] = [
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
  ];
  for (const [normalAxis, a, b] of faces) {
    for (const sign of [1, -1]) addFace(shape, half, inner, radiusM, normalAxis, sign, a, b);
  }
  return shape;
}

/** One face of a box through the origin. Only the components of `size` on the other two axes matter. */
export function panel(size: Triple, normalAxis: Axis, side: 1 | -1): Shape {
  const shape: Shape = { positions: [], normals: [], uvM: [], indices: [] };
  const half = size.map((s, axis) => (axis === normalAxis ? 0 : s / 2)) as unknown as Triple;
  addFace(shape, half, half, 0, normalAxis, side, ((normalAxis + 1) % 3) as Axis, ((normalAxis + 2) % 3) as Axis);
  return shape;
}

function addFace(shape: Shape, half: Triple, inner: Triple, radiusM: number, normalAxis: Axis, sign: number, a: Axis, b: Axis): void {
  const along = gridLines(half[a], radiusM);
  const across = gridLines(half[b], radiusM);
  const first = shape.positions.length / 3;
  for (const y of across) {
    for (const x of along) {
      const flat = [0, 0, 0];
      flat[normalAxis] = sign * half[normalAxis];
      flat[a] = x;
      flat[b] = y;
      const outward = flat.map((p, axis) => (radiusM > 0 ? p - Math.min(Math.max(p, -(inner[axis] ?? 0)), inner[axis] ?? 0) : 0));
      if (radiusM === 0) outward[normalAxis] = sign;
      const length = Math.hypot(...outward);
      const normal = outward.map((n) => n / length);
      const point =
        radiusM === 0
          ? flat
          : flat.map((p, axis) => Math.min(Math.max(p, -(inner[axis] ?? 0)), inner[axis] ?? 0) + (normal[axis] ?? 0) * radiusM);
      shape.positions.push(...point);
      shape.normals.push(...normal);
      shape.uvM.push(...boxUv(flat, normalAxis));
    }
  }
  // (a, b, normal) is right-handed, so this order faces outward if the sign is positive.
  addGrid(shape.indices, first, along.length, across.length, sign > 0);
}

/**
 * UV in meters of a point on a face of a box. Seen from outside, u goes to the right and v up; on horizontal faces u goes along x and v
 * along −z.
 */
function boxUv([x = 0, y = 0, z = 0]: readonly number[], normalAxis: Axis): readonly [number, number] {
  if (normalAxis === 1) return [x, -z];
  return normalAxis === 0 ? [-z, y] : [x, y];
}

function gridLines(half: number, radiusM: number): number[] {
  const flat = Math.max(half - radiusM, 0);
  const cells = Math.max(1, Math.ceil((2 * flat) / STEP_M));
  const lines = Array.from({ length: cells + 1 }, (_, i) => -flat + (2 * flat * i) / cells);
  if (radiusM === 0) return lines;
  const corner = (radiusM < SMALL_RADIUS_M ? [1] : [1, 0.66, 0.33]).map((t) => flat + radiusM * t);
  return [...corner.map((c) => -c), ...lines, ...corner.reverse()];
}

function addGrid(indices: number[], first: number, columns: number, rows: number, outward: boolean): void {
  for (let j = 0; j + 1 < rows; j++) {
    for (let i = 0; i + 1 < columns; i++) {
      const p = first + j * columns + i;
      const quad = [p, p + 1, p + columns + 1, p, p + columns + 1, p + columns];
      indices.push(...(outward ? quad : quad.reverse()));
    }
  }
}

/** Surface of revolution of a profile of [radius, height] about the y axis, from the bottom up; closed where the radius is 0. */
export function lathe(profile: readonly (readonly [number, number])[], segments = 20): Shape {
  const shape: Shape = { positions: [], normals: [], uvM: [], indices: [] };
  profile.forEach(([radius, height], i) => {
    const [r0, h0] = profile[Math.max(i - 1, 0)] ?? [radius, height];
    const [r1, h1] = profile[Math.min(i + 1, profile.length - 1)] ?? [radius, height];
    const length = Math.hypot(r1 - r0, h1 - h0) || 1;
    const [out, up] = [(h1 - h0) / length, (r0 - r1) / length];
    for (let s = 0; s <= segments; s++) {
      const angle = (s / segments) * 2 * Math.PI;
      const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
      shape.positions.push(radius * cos, height, -radius * sin);
      shape.normals.push(out * cos, up, -out * sin);
      shape.uvM.push(angle * 0.3, height);
    }
  });
  addGrid(shape.indices, 0, segments + 1, profile.length, true);
  return shape;
}

/** A hanging cloth in the x–y plane, folded along z. */
export function curtain(widthM: number, heightM: number, folds: number, depthM: number): Shape {
  const columns = folds * 8 + 1;
  const rows = Math.ceil(heightM / STEP_M) + 1;
  return sheet(columns, rows, (s, t) => {
    const phase = s * folds * 2 * Math.PI;
    return {
      point: [(s - 0.5) * widthM, (t - 0.5) * heightM, Math.sin(phase) * depthM],
      normal: [(-Math.cos(phase) * depthM * folds * 2 * Math.PI) / widthM, 0, 1],
      uvM: [s * widthM * 1.6, t * heightM],
    };
  });
}

/** A leaf on an arching stalk from the origin towards +x. */
export function leafBlade(lengthM: number, widthM: number, rise: number): Shape {
  return sheet(3, 8, (s, t) => {
    const width = widthM * Math.sin(Math.PI * Math.min(0.06 + t * 0.94, 0.97)) ** 0.8;
    const height = rise * t - rise * 0.75 * t * t;
    return {
      point: [lengthM * t, height - 0.25 * width * Math.abs(2 * s - 1) ** 2 + 0.02, (s - 0.5) * width],
      normal: [(-rise * (1 - 1.5 * t)) / lengthM, 1, 0.5 * (2 * s - 1)],
      uvM: [s, t],
    };
  });
}

interface SheetPoint {
  readonly point: Triple;
  readonly normal: Triple;
  readonly uvM: readonly [number, number];
}

function sheet(columns: number, rows: number, at: (s: number, t: number) => SheetPoint): Shape {
  const shape: Shape = { positions: [], normals: [], uvM: [], indices: [] };
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const { point, normal, uvM } = at(i / (columns - 1), j / (rows - 1));
      const length = Math.hypot(...normal);
      shape.positions.push(...point);
      shape.normals.push(...normal.map((n) => n / length));
      shape.uvM.push(...uvM);
    }
  }
  addGrid(shape.indices, 0, columns, rows, true);
  return shape;
}
