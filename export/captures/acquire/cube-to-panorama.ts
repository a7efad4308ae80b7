/** What one of six cameras saw: color as premultiplied RGBA, and depth along its axis in meters, 0 for nothing; rows from the top. */
export interface Face {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly pixels: Uint8Array;
  readonly meters: Float32Array;
}

/** A 360° photograph: premultiplied RGBA, and distances from the camera in meters. */
export interface Panorama extends Face {
  readonly pixels: Uint8Array<ArrayBuffer>;
  readonly meters: Float32Array<ArrayBuffer>;
}

/**
 * The rotations of the six cameras, column-major 4×4, from the axes of the panorama: ahead (−z), behind, right, left, up, down. The order is
 * that of `panoramaFromFaces`.
 */
export const FACE_POSES: readonly (readonly number[])[] = [
  [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1],
  [0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1],
  [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1],
  [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1],
  [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1],
];

/** The side of faces with which the middle of a face has as many pixels per radian as a panorama, with a border of a pixel. */
export function faceSidePx(panoramaWidthPx: number): number {
  return Math.ceil(panoramaWidthPx / Math.PI) + 2;
}

/** The tangent of half the field of view of a face: a right angle, and the border of a pixel that linear sampling needs. */
export function faceTangent(sidePx: number): number {
  return sidePx / (sidePx - 2);
}

/**
 * Draws a 360° photograph from six square ones: twice as wide as high, with what is ahead (−z) in its center. Colors are sampled linearly;
 * depths are those of the nearest pixel, as distances from the camera, because a mean over an edge is a depth where nothing is.
 */
export function panoramaFromFaces(faces: readonly Face[], widthPx: number): Panorama {
  const heightPx = widthPx / 2;
  const pixels = new Uint8Array(4 * widthPx * heightPx);
  const meters = new Float32Array(widthPx * heightPx);
  for (let row = 0; row < heightPx; row++) {
    const latitude = Math.PI * (0.5 - (row + 0.5) / heightPx);
    const y = Math.sin(latitude);
    for (let column = 0; column < widthPx; column++) {
      const longitude = 2 * Math.PI * ((column + 0.5) / widthPx - 0.5);
      const x = Math.cos(latitude) * Math.sin(longitude);
      const z = -Math.cos(latitude) * Math.cos(longitude);
      const index = faceOf(x, y, z);
      const face = faces[index];
      const m = FACE_POSES[index];
      if (!face || !m) throw new Error('A panorama needs six faces.');
      const along = (axis: number): number => x * (m[4 * axis] ?? 0) + y * (m[4 * axis + 1] ?? 0) + z * (m[4 * axis + 2] ?? 0);
      const ahead = -along(2);
      const tangent = faceTangent(face.widthPx);
      const u = (0.5 + along(0) / ahead / tangent / 2) * face.widthPx;
      const v = (0.5 - along(1) / ahead / tangent / 2) * face.heightPx;
      const at = row * widthPx + column;
      sampleColor(face, u, v, pixels, 4 * at);
      // The ray is a unit vector: the depth along the axis is the distance times `ahead`.
      meters[at] = (face.meters[Math.floor(v) * face.widthPx + Math.floor(u)] ?? 0) / ahead;
    }
  }
  return { widthPx, heightPx, pixels, meters };
}

function faceOf(x: number, y: number, z: number): number {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (az >= ax && az >= ay) return z < 0 ? 0 : 1;
  if (ax >= ay) return x > 0 ? 2 : 3;
  return y > 0 ? 4 : 5;
}

function sampleColor({ widthPx, heightPx, pixels }: Face, u: number, v: number, out: Uint8Array, to: number): void {
  const left = Math.min(widthPx - 2, Math.max(0, Math.floor(u - 0.5)));
  const top = Math.min(heightPx - 2, Math.max(0, Math.floor(v - 0.5)));
  const [fx, fy] = [u - 0.5 - left, v - 0.5 - top];
  const from = 4 * (top * widthPx + left);
  const below = from + 4 * widthPx;
  for (let c = 0; c < 4; c++) {
    const upper = (pixels[from + c] ?? 0) * (1 - fx) + (pixels[from + 4 + c] ?? 0) * fx;
    const lower = (pixels[below + c] ?? 0) * (1 - fx) + (pixels[below + 4 + c] ?? 0) * fx;
    out[to + c] = Math.round(upper * (1 - fy) + lower * fy);
  }
}
