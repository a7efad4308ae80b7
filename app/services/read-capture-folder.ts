import { lstat, readdir } from 'node:fs/promises';
import { extname, join } from 'node:path';
import { readColmapBinary, readColmapText } from '../../export/captures/colmap.ts';
import { equirectangularLens, type Lens } from '../../export/captures/lens.ts';
import { readGltfMesh } from '../../export/captures/mesh-gltf.ts';
import { readObj } from '../../export/captures/mesh-obj.ts';
import { readPly } from '../../export/captures/mesh-ply.ts';
import { seesMesh } from '../../export/captures/plausible.ts';
import { checkPose, type SourceCapture, type SourceView } from '../../export/captures/source-view.ts';
import { readTransforms } from '../../export/captures/transforms-json.ts';
import { ModelError } from '../../export/gltf/document.ts';
import { imageSize } from '../../export/gltf/image-size.ts';
import { readWholeModel } from '../../export/gltf/whole-model.ts';
import { CAPTURE_FILE, CAPTURE_LIMITS, CaptureError, type CaptureMesh, isInside } from '../../nodes/kit/capture.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { errorCode } from './file-errors.ts';
import { readSource } from './read-source.ts';

/** A photograph that was found, with the lens for its size. */
export interface FoundView {
  readonly view: SourceView;
  /** Absolute path. */
  readonly file: string;
  readonly lens: Lens;
}

export interface FoundCapture {
  readonly source: SourceCapture;
  readonly views: readonly FoundView[];
  /** Null if there is none: the depth of the photographs makes one. */
  readonly mesh: CaptureMesh | null;
  /** Photographs that cameras have, and that are not there. */
  readonly withoutPhotograph: readonly string[];
  /** Photographs that are there, and that no camera has. */
  readonly withoutCamera: readonly string[];
  /** Warnings. */
  readonly diagnostics: readonly Diagnostic[];
}

const MAX_FILE_BYTES = 2 ** 30;
const MAX_PHOTO_BYTES = 256 * 2 ** 20;
/** Folders in which reconstructions keep their cameras. */
const CAMERA_FOLDERS = ['', 'sparse/0', 'sparse', 'colmap/sparse/0', 'sparse_bin'];
const PHOTO_FOLDERS = ['images', ''];
/** In this order, because the mesh of points that `reconstruct` writes into the last one is coarser than all others. */
const MESH_FOLDERS = ['', 'dense', 'sparse/0'];
/** The mesh of points, beside the cameras. */
export const SPARSE_MESH = 'mesh.ply';
const DEPTH_FOLDERS = ['depth', 'depths', 'depth_maps', 'stereo/depth_maps'];
/** Views below which a place has gaps from most sides. */
const FEW_VIEWS = 4;
/** How far the shape of a photograph may differ from that of its camera. */
const SHAPE_TOLERANCE = 0.01;

/** Reads the cameras and the mesh of a folder, and finds its photographs. @throws CaptureError */
export async function readCaptureFolder(folder: string): Promise<FoundCapture> {
  const source = await readCameras(folder);
  const warnings: string[] = [];
  checkNames(source.views);
  if (source.views.length > CAPTURE_LIMITS.views) {
    throw new CaptureError(`it has ${source.views.length} photographs, more than ${CAPTURE_LIMITS.views}. Remove some of them`);
  }
  const views: FoundView[] = [];
  const missing: string[] = [];
  for (const view of source.views) {
    checkPose(view.worldFromCamera, view.name);
    const file = await findPhoto(folder, view.name);
    if (file === null) missing.push(view.name);
    // Names without their ending, or from another folder, may mean the same file.
    else if (views.some((other) => other.file === file.path)) throw new CaptureError(`two cameras have the photograph ${view.name}`);
    else views.push({ view, file: file.path, lens: lensFor(view, file.bytes) });
  }
  if (views.length === 0) {
    throw new CaptureError(`none of its ${source.views.length} photographs is in the folder, such as ${missing[0] ?? 'any'}`);
  }
  if (missing.length > 0) warnings.push(`${counted(missing.length, 'camera has', 'cameras have')} no photograph, such as ${missing[0]}.`);
  const without = await photosWithoutCamera(folder, views);
  if (without.length > 0)
    warnings.push(`${counted(without.length, 'photograph has', 'photographs have')} no camera, such as ${without[0]}.`);
  if (views.length < FEW_VIEWS && !views.some(({ lens }) => lens.projection === 'equirectangular'))
    warnings.push(`It has ${counted(views.length, 'photograph', 'photographs')} only, so most sides are seen once or never.`);
  const mesh = await readMesh(folder);
  const blind = views.filter(({ view, lens }) => mesh && !seesMesh(mesh, lens, view.worldFromCamera));
  if (blind.length > 0) {
    const count = counted(blind.length, 'photograph shows', 'photographs show');
    warnings.push(`${count} nothing of the mesh, such as ${blind[0]?.view.name}. Mesh and cameras may have different units or axes.`);
  }
  return { source, views, mesh, withoutPhotograph: missing, withoutCamera: without, diagnostics: warnings.map(warning) };
}

function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`;
}

function warning(message: string): Diagnostic {
  return { code: 'SCR069', severity: 'warning', message };
}

/** Whether a folder has files of cameras, or needs none. @throws CaptureError if they are damaged */
export async function hasCameras(folder: string): Promise<boolean> {
  return (await findCameras(folder)) !== null;
}

/** Reads the cameras of a folder. @throws CaptureError if it has none */
export async function readCameras(folder: string): Promise<SourceCapture> {
  const found = await findCameras(folder);
  if (found) return found;
  throw new CaptureError('it has no cameras: neither cameras.txt and images.txt (or .bin) of COLMAP nor transforms.json');
}

/** @throws CaptureError if they are damaged, or if the folder is no folder of photographs but a capture */
async function findCameras(folder: string): Promise<SourceCapture | null> {
  if (await readIfThere(join(folder, CAPTURE_FILE))) {
    throw new CaptureError('it is a capture already; import the folder of photographs that it was made from');
  }
  for (const place of CAMERA_FOLDERS) {
    const read = (name: string) => readIfThere(join(folder, place, name));
    for (const [ending, reader] of [
      ['bin', readColmapBinary],
      ['txt', readColmapText],
    ] as const) {
      const cameras = await read(`cameras.${ending}`);
      const images = await read(`images.${ending}`);
      if (cameras && images) return reader({ cameras, images, points: await read(`points3D.${ending}`) });
    }
  }
  const transforms = await readIfThere(join(folder, 'transforms.json'));
  if (transforms) return readTransforms(transforms);
  return findPanorama(folder);
}

/** What a single 360° photograph without cameras is called. */
export const PANORAMA_FORM = 'one 360° photograph';

/** A photograph that is twice as wide as high, if there is exactly one photograph and no other description. */
async function findPanorama(folder: string): Promise<SourceCapture | null> {
  const photos: string[] = [];
  for (const place of PHOTO_FOLDERS) {
    const names = await readdir(join(folder, place)).catch(() => []);
    photos.push(...names.filter((name) => PHOTO_ENDING.test(name) && !/depth/i.test(name)));
  }
  const [name] = photos;
  if (name === undefined || photos.length !== 1) return null;
  const photo = await findPhoto(folder, name);
  const size = photo && imageSize(photo.bytes);
  if (!size || size.widthPx !== 2 * size.heightPx) return null;
  const lens = (widthPx: number, heightPx: number) => equirectangularLens(widthPx, heightPx, name);
  const still = { model: 'EQUIRECTANGULAR', worldFromCamera: IDENTITY, depthName: null, sizePx: null, observations: new Float64Array(0) };
  return { form: PANORAMA_FORM, pointCount: 0, views: [{ name, lens, ...still }] };
}

const PHOTO_ENDING = /\.(jpe?g|png)$/i;
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function checkNames(views: readonly SourceView[]): void {
  if (views.length === 0) throw new CaptureError('it has no cameras');
  const names = new Set<string>();
  for (const { name } of views) {
    if (!isInside(name)) throw new CaptureError(`the photograph ${JSON.stringify(name)} is outside the folder`);
    if (names.has(name)) throw new CaptureError(`two cameras have the photograph ${name}`);
    names.add(name);
  }
}

/** The photograph of a name; file names of `transforms.json` may lack their ending. */
async function findPhoto(folder: string, name: string): Promise<{ readonly path: string; readonly bytes: Uint8Array } | null> {
  const names = extname(name) === '' ? ['.png', '.jpg', '.jpeg'].map((ending) => `${name}${ending}`) : [name];
  for (const place of PHOTO_FOLDERS) {
    for (const each of names) {
      const path = join(folder, place, each);
      const bytes = await readIfThere(path, MAX_PHOTO_BYTES);
      if (bytes) return { path, bytes };
    }
  }
  return null;
}

function lensFor(view: SourceView, bytes: Uint8Array): Lens {
  const size = imageSize(bytes);
  if (!size) throw new CaptureError(`the photograph ${view.name} is neither a JPEG nor a PNG file`);
  const { widthPx, heightPx } = size;
  if (Math.max(widthPx, heightPx) > CAPTURE_LIMITS.sidePx) {
    throw new CaptureError(`the photograph ${view.name} is ${widthPx} × ${heightPx} pixels, more than ${CAPTURE_LIMITS.sidePx}`);
  }
  const [cameraWidthPx, cameraHeightPx] = view.sizePx ?? [widthPx, heightPx];
  const lens = view.lens(cameraWidthPx, cameraHeightPx);
  const sx = widthPx / cameraWidthPx;
  const sy = heightPx / cameraHeightPx;
  if (sx === 1 && sy === 1) return lens;
  if (Math.abs(sx / sy - 1) > SHAPE_TOLERANCE) {
    throw new CaptureError(
      `the photograph ${view.name} is ${widthPx} × ${heightPx} pixels, but its camera ${cameraWidthPx} × ${cameraHeightPx}`,
    );
  }
  return { ...lens, widthPx, heightPx, fxPx: lens.fxPx * sx, fyPx: lens.fyPx * sy, cxPx: lens.cxPx * sx, cyPx: lens.cyPx * sy };
}

async function photosWithoutCamera(folder: string, views: readonly FoundView[]): Promise<readonly string[]> {
  const known = new Set(views.map(({ file }) => file));
  const names = await readdir(join(folder, 'images')).catch(() => []);
  return names.filter((name) => PHOTO_ENDING.test(name) && !known.has(join(folder, 'images', name))).sort();
}

/** Names of meshes that reconstructions write, the best first; then any other. */
const MESH_NAMES = ['mesh.ply', 'meshed-poisson.ply', 'meshed-delaunay.ply', 'mesh.obj', 'mesh.glb', 'mesh.gltf'];
const MESH_ENDING = /\.(ply|obj|glb|gltf)$/i;
/** Files of points, which are no meshes. */
const POINTS_FILE = /^(fused|points3D|sparse_pc)\.ply$/i;

async function readMesh(folder: string): Promise<CaptureMesh | null> {
  for (const place of MESH_FOLDERS) {
    const name = await findMesh(join(folder, place));
    if (name !== null) return readMeshFile(join(folder, place), name);
  }
  return null;
}

async function findMesh(folder: string): Promise<string | null> {
  const names = (await readdir(folder).catch(() => [])).filter((name) => MESH_ENDING.test(name) && !POINTS_FILE.test(name));
  return MESH_NAMES.find((known) => names.includes(known)) ?? names.sort()[0] ?? null;
}

/** Whether a folder has a mesh or depth of other programs. */
export async function hasSurface(folder: string): Promise<boolean> {
  const meshes = await Promise.all(MESH_FOLDERS.slice(0, -1).map((place) => findMesh(join(folder, place))));
  const depths = await Promise.all(DEPTH_FOLDERS.map((place) => readdir(join(folder, place)).catch(() => [])));
  return meshes.some((name) => name !== null) || depths.some((names) => names.length > 0);
}

/** Reads a mesh: PLY, OBJ, or glTF with its files. @throws CaptureError */
export async function readMeshFile(folder: string, name: string): Promise<CaptureMesh> {
  const bytes = await readSource(join(folder, name), MAX_FILE_BYTES);
  const ending = extname(name).toLowerCase();
  if (ending === '.ply') return readPly(bytes);
  if (ending === '.obj') return readObj(bytes);
  try {
    const { gltf } = await readWholeModel(bytes, name, (path) => {
      if (!isInside(path)) throw new CaptureError(`the mesh refers to the file ${JSON.stringify(path)} outside the folder`);
      return readSource(join(folder, path), MAX_FILE_BYTES);
    });
    return readGltfMesh(gltf);
  } catch (error) {
    throw error instanceof ModelError ? new CaptureError(`the mesh ${name} cannot be read: ${error.message.replace(/\.$/, '')}`) : error;
  }
}

async function readIfThere(path: string, maxBytes = MAX_FILE_BYTES): Promise<Uint8Array<ArrayBuffer> | null> {
  try {
    await lstat(path);
  } catch (error) {
    if (errorCode(error) === 'ENOENT' || errorCode(error) === 'ENOTDIR') return null;
  }
  return readSource(path, maxBytes);
}
