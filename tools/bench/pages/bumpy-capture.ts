import { type CaptureTextures, createCaptureTextures } from '../../../export/runtime/assets/capture/capture-textures.ts';
import { createGlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import { workAtOnce } from '../../../export/runtime/gl/spread-work.ts';
import type { CaptureDocument, CaptureMesh, Pinhole } from '../../../nodes/kit/capture.ts';
import { meshCounts } from '../../../nodes/kit/capture.ts';
import { PHOTO_WHOLE } from '../../../nodes/kit/capture-asset.ts';

/** How far the cameras are from the middle of the ball, meters. */
const AWAY_M = 3;
const PHOTO_PX = 64;
/** The focal length, as a share of the width of a photograph. */
const FOCAL = 1.25;

/** The lens of each camera, with photographs of `sidePx` by `sidePx`. */
export function bumpyLens(sidePx: number): Pinhole {
  const [focalPx, middlePx] = [FOCAL * sidePx, sidePx / 2];
  return { widthPx: sidePx, heightPx: sidePx, fxPx: focalPx, fyPx: focalPx, cxPx: middlePx, cyPx: middlePx };
}

/** The lens of each camera, with small photographs. */
export const bumpyPinhole: Pinhole = bumpyLens(PHOTO_PX);

/** Poses of cameras around the ball, on a Fibonacci lattice. */
export function bumpyPoses(count: number): readonly (readonly number[])[] {
  return Array.from({ length: count }, (_, view) => {
    const y = 1 - (2 * view + 1) / count;
    const turn = Math.PI * (3 - Math.sqrt(5)) * view;
    const away = Math.sqrt(1 - y * y);
    return [...poseTowardsMiddle([AWAY_M * away * Math.cos(turn), AWAY_M * y, AWAY_M * away * Math.sin(turn)])];
  });
}

/**
 * A ball with bumps of about `vertexCount` vertices and a radius of about 1 m, photographed from all sides in a pattern per camera.
 *
 * @param photoPx Width and height of photographs and depth maps.
 */
export async function bumpyCapture(
  gl: WebGL2RenderingContext,
  vertexCount: number,
  viewCount: number,
  photoPx = PHOTO_PX,
): Promise<CaptureTextures> {
  const mesh = bumpyBall(vertexCount);
  const lens = bumpyLens(photoPx);
  const views = bumpyPoses(viewCount).map((worldFromCamera, view) => ({ file: `${view}.png`, ...lens, worldFromCamera }));
  const document: CaptureDocument = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...meshCounts(mesh) }, views };
  const size = { photoPx: [photoPx, photoPx], depthPx: [photoPx, photoPx] } as const;
  const textures = createCaptureTextures(createGlObjects(gl), document, size, async (work) => workAtOnce(work));
  await textures.setMesh(mesh);
  for (const view of views.keys()) await textures.setPhoto(view, new Blob([await pattern(view)]), PHOTO_WHOLE);
  textures.finish();
  await textures.bake();
  return textures;
}

/** A rigid pose at `position` with −z to the middle, column-major. */
export function poseTowardsMiddle(position: readonly [number, number, number]): Float32Array {
  const [x, y, z] = position;
  const length = Math.hypot(x, y, z);
  const back = [x / length, y / length, z / length] as const;
  const flat = Math.hypot(back[0], back[2]);
  const right = [back[2] / flat, 0, -back[0] / flat] as const;
  const up = [back[1] * right[2], back[2] * right[0] - back[0] * right[2], -back[1] * right[0]] as const;
  return Float32Array.of(...right, 0, ...up, 0, ...back, 0, ...position, 1);
}

/** The inverse of a rigid pose, column-major. */
export function inverseOfRigid(rigid: Float32Array): Float32Array {
  const at = (row: number, column: number): number => rigid[4 * column + row] ?? 0;
  const inverse = new Float32Array(16);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) inverse[4 * column + row] = at(column, row);
    for (let i = 0; i < 3; i++) inverse[12 + row] = (inverse[12 + row] ?? 0) - at(i, row) * at(i, 3);
  }
  inverse[15] = 1;
  return inverse;
}

/** Latitudes and longitudes; as many rows as columns over 2. */
export function bumpyBall(vertexCount: number): CaptureMesh {
  const rows = Math.round(Math.sqrt(vertexCount / 2));
  const columns = 2 * rows;
  const positions = new Float32Array(3 * rows * columns);
  const indices: number[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const latitude = (Math.PI * (row + 0.5)) / rows;
      const longitude = (2 * Math.PI * column) / columns;
      const radius = 1 + 0.15 * Math.sin(6 * longitude) * Math.sin(5 * latitude);
      const around = radius * Math.sin(latitude);
      positions.set([around * Math.cos(longitude), radius * Math.cos(latitude), around * Math.sin(longitude)], 3 * at);
      if (row === rows - 1) continue;
      const next = row * columns + ((column + 1) % columns);
      indices.push(at, next, at + columns, next, next + columns, at + columns);
    }
  }
  return { positions, indices: Uint32Array.from(indices) };
}

/** Stripes in a color and a direction of their own. */
export async function pattern(view: number): Promise<ArrayBuffer> {
  const canvas = new OffscreenCanvas(PHOTO_PX, PHOTO_PX);
  const ctx = canvas.getContext('2d');
  if (!ctx) throw new Error('No 2D context.');
  ctx.fillStyle = `hsl(${(view * 137) % 360} 60% 50%)`;
  ctx.fillRect(0, 0, PHOTO_PX, PHOTO_PX);
  ctx.rotate(view);
  ctx.fillStyle = '#0004';
  for (let x = -2 * PHOTO_PX; x < 2 * PHOTO_PX; x += 12) ctx.fillRect(x, -2 * PHOTO_PX, 6, 4 * PHOTO_PX);
  return (await canvas.convertToBlob()).arrayBuffer();
}
