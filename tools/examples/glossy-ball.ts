import sharp from 'sharp';
import type { CaptureDocument, CaptureView } from '../../nodes/kit/capture.ts';

/** A glossy ball on a checkered table, computed ray by ray: photographs whose highlight moves with the camera. Meters. */

type Vector = readonly [number, number, number];

const RADIUS = 0.2;
const CENTER: Vector = [0, RADIUS, 0];
const TABLE = 0.6;
const TOWARDS_LIGHT = unit([0.4, 0.9, 0.5]);

/** The size and focal length of the photographs. */
const PHOTO = { widthPx: 320, heightPx: 240, fxPx: 300, fyPx: 300, cxPx: 160, cyPx: 120 };

/** A camera on a sphere around the ball that looks at it. */
export function cameraAround(azimuthRad: number, elevationRad: number, distanceM = 1): CaptureView {
  const back: Vector = [
    Math.cos(elevationRad) * Math.sin(azimuthRad),
    Math.sin(elevationRad),
    Math.cos(elevationRad) * Math.cos(azimuthRad),
  ];
  const right = unit(cross([0, 1, 0], back));
  const up = cross(back, right);
  const position = add(CENTER, back, distanceM);
  return { file: '', ...PHOTO, worldFromCamera: [...right, 0, ...up, 0, ...back, 0, ...position, 1] };
}

/** What a camera sees: RGB, rows from the top. */
export function photographBall({ widthPx, heightPx, fxPx, fyPx, cxPx, cyPx, worldFromCamera: m }: CaptureView): Uint8Array {
  const pixels = new Uint8Array(widthPx * heightPx * 3);
  const axis = (i: number): Vector => [m[4 * i] ?? 0, m[4 * i + 1] ?? 0, m[4 * i + 2] ?? 0];
  const [right, up, back, eye] = [axis(0), axis(1), axis(2), axis(3)];
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const x = (column + 0.5 - cxPx) / fxPx;
      const y = -(row + 0.5 - cyPx) / fyPx;
      const ray = unit(add(add([-back[0], -back[1], -back[2]], right, x), up, y));
      shade(eye, ray).forEach((value, c) => {
        pixels[(row * widthPx + column) * 3 + c] = Math.round(255 * Math.min(1, Math.max(0, value)));
      });
    }
  }
  return pixels;
}

function shade(eye: Vector, ray: Vector): Vector {
  const from = add(eye, CENTER, -1);
  const along = dot(from, ray);
  const root = along * along - dot(from, from) + RADIUS * RADIUS;
  if (root > 0) {
    const point = add(eye, ray, -along - Math.sqrt(root));
    const normal = unit(add(point, CENTER, -1));
    const light = Math.max(0, dot(normal, TOWARDS_LIGHT));
    const mirrored = add(ray, normal, -2 * dot(ray, normal));
    const glint = Math.max(0, dot(mirrored, TOWARDS_LIGHT)) ** 60;
    return [0.15 + 0.5 * light + glint, 0.08 + 0.15 * light + glint, 0.1 + 0.12 * light + glint];
  }
  const distance = -eye[1] / ray[1];
  const point = add(eye, ray, distance);
  if (distance <= 0 || Math.abs(point[0]) > TABLE || Math.abs(point[2]) > TABLE) return [0.5, 0.55, 0.6];
  const isLight = (Math.floor(point[0] * 10) + Math.floor(point[2] * 10)) % 2 === 0;
  return isLight ? [0.75, 0.72, 0.65] : [0.35, 0.38, 0.36];
}

const STEPS = 48;

/** The mesh of ball and table as `mesh.bin`. */
function meshOf(steps: number): { readonly bytes: Uint8Array; readonly vertexCount: number; readonly triangleCount: number } {
  const positions: number[] = [];
  const indices: number[] = [];
  const grid = (columns: number, rows: number, at: (u: number, v: number) => Vector): void => {
    const first = positions.length / 3;
    for (let row = 0; row <= rows; row++)
      for (let column = 0; column <= columns; column++) positions.push(...at(column / columns, row / rows));
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const a = first + row * (columns + 1) + column;
        indices.push(a, a + 1, a + columns + 1, a + 1, a + columns + 2, a + columns + 1);
      }
    }
  };
  grid(steps, steps / 2, (u, v) =>
    add(
      CENTER,
      [Math.sin(Math.PI * v) * Math.cos(2 * Math.PI * u), Math.cos(Math.PI * v), Math.sin(Math.PI * v) * Math.sin(2 * Math.PI * u)],
      RADIUS,
    ),
  );
  grid(steps, steps, (u, v) => [TABLE * (2 * u - 1), 0, TABLE * (2 * v - 1)]);
  const bytes = new Uint8Array(4 * (positions.length + indices.length));
  new Float32Array(bytes.buffer, 0, positions.length).set(positions);
  new Uint32Array(bytes.buffer, 4 * positions.length).set(indices);
  return { bytes, vertexCount: positions.length / 3, triangleCount: indices.length / 3 };
}

const ELEVATIONS = [0.35, 0.75];
const AROUND = 10;

/**
 * The files of the capture by their paths in its folder.
 *
 * @param around Number of cameras in each of two rings.
 * @param steps Number of quads along each side of the mesh.
 */
export async function makeGlossyBall(around = AROUND, steps = STEPS): Promise<Readonly<Record<string, Uint8Array>>> {
  const { bytes, ...counts } = meshOf(steps);
  const files: Record<string, Uint8Array> = { 'mesh.bin': bytes };
  const views: CaptureView[] = [];
  for (const [ring, elevation] of ELEVATIONS.entries()) {
    for (let i = 0; i < around; i++) {
      const camera = cameraAround((2 * Math.PI * (i + ring / 2)) / around, elevation);
      const file = `views/${String(views.length).padStart(3, '0')}.jpg`;
      const raw = { width: camera.widthPx, height: camera.heightPx, channels: 3 } as const;
      files[file] = await sharp(photographBall(camera), { raw }).jpeg({ quality: 85 }).toBuffer();
      views.push({ ...camera, file });
    }
  }
  const document: CaptureDocument = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...counts }, views };
  files['capture.json'] = new TextEncoder().encode(`${JSON.stringify(document, null, 1)}\n`);
  return files;
}

function add(a: Vector, b: Vector, factor: number): Vector {
  return [a[0] + b[0] * factor, a[1] + b[1] * factor, a[2] + b[2] * factor];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(a: Vector): Vector {
  return add([0, 0, 0], a, 1 / Math.hypot(...a));
}
