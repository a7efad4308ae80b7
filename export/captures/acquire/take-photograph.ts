import { FACE_POSES, type Face, faceSidePx, faceTangent, panoramaFromFaces } from './cube-to-panorama.ts';
import type { AcquiredCamera } from './write-transforms.ts';

/** Rows from the top. A layer that is smaller than the view gives a smaller photograph. */
export interface Photograph {
  /** Premultiplied RGBA. */
  readonly color: { readonly widthPx: number; readonly heightPx: number; readonly pixels: Uint8Array<ArrayBuffer> };
  /** Along the axis of the camera, or distances in 360° photographs. */
  readonly depth: { readonly widthPx: number; readonly heightPx: number; readonly meters: Float32Array<ArrayBuffer> };
}

/**
 * Draws the scene for a pinhole camera with its center in the middle of the picture.
 *
 * @param tangents Those of half the horizontal and half the vertical field of view.
 */
export type TakePicture = (worldFromCamera: readonly number[], tangents: readonly [x: number, y: number]) => Promise<Photograph>;

/** The size of the pictures that photographs of this camera are made from. */
export function pictureSize({ projection, widthPx, heightPx }: AcquiredCamera): readonly [widthPx: number, heightPx: number] {
  if (projection === 'perspective') return [widthPx, heightPx];
  const sidePx = faceSidePx(widthPx);
  return [sidePx, sidePx];
}

/**
 * Takes a photograph: a picture, or a 360° photograph from six of them.
 *
 * @param worldFromCamera Column-major 4×4.
 */
export async function takePhotograph(camera: AcquiredCamera, worldFromCamera: readonly number[], take: TakePicture): Promise<Photograph> {
  const [pictureWidthPx, pictureHeightPx] = pictureSize(camera);
  if (camera.projection === 'perspective') {
    const y = Math.tan(camera.fovYRad / 2);
    return take(worldFromCamera, [(y * pictureWidthPx) / pictureHeightPx, y]);
  }
  const tangent = faceTangent(pictureWidthPx);
  const faces: Face[] = [];
  for (const cameraFromFace of FACE_POSES) {
    const { color, depth } = await take(turned(worldFromCamera, cameraFromFace), [tangent, tangent]);
    if (color.widthPx !== depth.widthPx) throw new Error('The color and the depth of a layer have different sizes.');
    faces.push({ ...color, meters: depth.meters });
  }
  const { pixels, meters, widthPx, heightPx } = panoramaFromFaces(faces, camera.widthPx);
  return { color: { widthPx, heightPx, pixels }, depth: { widthPx, heightPx, meters } };
}

/** The pose of a face: the rotations multiplied, the position kept. */
function turned(pose: readonly number[], cameraFromFace: readonly number[]): readonly number[] {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, Math.floor(i / 4)];
    if (column === 3) return pose[i] ?? 0;
    return [0, 1, 2].reduce((sum, k) => sum + (pose[4 * k + row] ?? 0) * (cameraFromFace[4 * column + k] ?? 0), 0);
  });
}
