import { type CaptureTextures, createCaptureTextures } from '../../../export/runtime/assets/capture/capture-textures.ts';
import { createGlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import { workAtOnce } from '../../../export/runtime/gl/spread-work.ts';
import type { CaptureDocument, CaptureMesh, Pinhole } from '../../../nodes/kit/capture.ts';
import { meshCounts } from '../../../nodes/kit/capture.ts';
import { PHOTO_WHOLE } from '../../../nodes/kit/capture-asset.ts';

/** How far the cameras are from the middle of the ball, meters. */
const AWAY_M = 3;
const PHOTO_PX = 64;
const FOCAL_PX = 80;

/** The lens of each camera. */
export const bumpyPinhole: Pinhole = {
  widthPx: PHOTO_PX,
  heightPx: PHOTO_PX,
  fxPx: FOCAL_PX,
  fyPx: FOCAL_PX,
  cxPx: PHOTO_PX / 2,
  cyPx: PHOTO_PX / 2,
};

/** Poses of cameras around the ball, on a Fibonacci lattice. */
export function bumpyPoses(count: number): readonly (readonly number[])[] {
  return Array.from({ length: count }, (_, view) => {
    const y = 1 - (2 * view + 1) / count;
    const turn = Math.PI * (3 - Math.sqrt(5)) * view;
    const away = Math.sqrt(1 - y * y);
    return [...poseTowardsMiddle([AWAY_M * away * Math.cos(turn), AWAY_M * y, AWAY_M * away * Math.sin(turn)])];
  });
}

/** A ball with bumps of about `vertexCount` vertices and a radius of about 1 m, photographed from all sides in a pattern per camera. */
export async function bumpyCapture(gl: WebGL2RenderingContext, vertexCount: number, viewCount: number): Promise<CaptureTextures> {
  const mesh = bumpyBall(vertexCount);
  const views = bumpyPoses(viewCount).map((worldFromCamera, view) => ({ file: `${view}.png`, ...bumpyPinhole, worldFromCamera }));
  const document: CaptureDocument = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...meshCounts(mesh) }, views };
  const size = { photoPx: [PHOTO_PX, PHOTO_PX], depthPx: [PHOTO_PX, PHOTO_PX] } as const;
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
