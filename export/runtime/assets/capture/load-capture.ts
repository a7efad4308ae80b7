import { CaptureError, type CaptureMesh, type CaptureMeshFile, readCapture, readCaptureMesh } from '../../../../nodes/kit/capture.ts';
import { type CaptureAsset, PHOTO_MISSING, PHOTO_REDUCED, PHOTO_WHOLE } from '../../../../nodes/kit/capture-asset.ts';
import { captureSize } from '../../../../nodes/kit/capture-size.ts';
import { photoBlob } from '../../../../nodes/kit/photo-blob.ts';
import type { FrameClock } from '../../clock.ts';
import type { GlObjects } from '../../gl/gl-objects.ts';
import { workAtOnce, workInTurns } from '../../gl/spread-work.ts';
import { limitHere } from '../on-phone.ts';
import { createCaptureTextures, type DoWork } from './capture-textures.ts';
import { loadDepthMeshes } from './load-depth-meshes.ts';

export interface LoadedCapture extends CaptureAsset {
  dispose(): void;
}

/** Photographs that are loaded before the mesh: as many as most pixels of an image need. */
const VIEWS_BEFORE_MESH = 4;

/**
 * Loads a capture: its photographs, the depth maps of its mesh from each camera, and the color of each vertex.
 *
 * A capture with a coarse mesh is shown as soon as that and one photograph are there. The other photographs follow, those that suit the eye
 * best first, each reduced at first. The mesh comes after the first few. In the end, the capture is the same as one that is loaded whole.
 *
 * On phones and headsets, a capture of a page takes at most its share, `phoneGpuBytes`: photographs are smaller, depth meshes left out, or the mesh stays
 * the coarse one.
 *
 * @param bytes `capture.json`.
 * @param path Its path, to which the other files are relative.
 * @param depthMeshes Whether its depth meshes are drawn.
 * @param show Receives the capture when it can be drawn, at the latest before the promise resolves.
 * @param delay Waits between parts of the work of the GPU, so that frames are drawn meanwhile. Absent: the work is done at once.
 * @returns The complete capture: the object that `show` received.
 * @throws CaptureError if a file is invalid. A capture that was shown stays as far as it is loaded, and is disposed by who received it.
 */
export async function loadCapture(
  objects: GlObjects,
  bytes: ArrayBuffer,
  path: string,
  load: (path: string) => Promise<ArrayBuffer>,
  depthMeshes: boolean,
  show: (capture: LoadedCapture) => void = () => {},
  delay?: FrameClock['delay'],
): Promise<LoadedCapture> {
  const document = readCapture(new TextDecoder().decode(bytes));
  const { gl } = objects;
  const { views, mesh, coarseMesh } = document;
  const layers = gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS) as number;
  if (views.length > layers) throw new CaptureError(`it has ${views.length} views, but the graphics of this device hold ${layers}`);
  const folder = path.slice(0, path.lastIndexOf('/') + 1);
  const file = (name: string): Promise<ArrayBuffer> => load(folder + name);
  const mostBytes = limitHere(document.phoneGpuBytes);
  const size = captureSize(document, { maxSidePx: objects.limits.maxTextureSizePx, depthMeshes, mostBytes });
  const isDisposed = (): boolean => disposals.length === 0;
  const doWork: DoWork = async (work) => (delay ? workInTurns(work, { gl, delay, isOver: isDisposed }) : workAtOnce(work));
  const textures = createCaptureTextures(objects, document, size, doWork);
  const disposals = [textures.dispose];
  let isShown = false;
  const capture: LoadedCapture = Object.assign(textures.asset, {
    dispose: () => {
      for (const release of disposals.splice(0)) release();
    },
  });
  const readMesh = async (one: CaptureMeshFile): Promise<CaptureMesh> => readCaptureMesh(one, await file(one.file));
  const setMesh = async (mesh: CaptureMesh): Promise<void> => {
    if (!isDisposed()) await textures.setMesh(mesh);
  };
  const setPhoto = async (index: number): Promise<void> => {
    const view = views[index];
    if (!view) return;
    const isReduced = view.reducedFile !== undefined && capture.loaded[index] === PHOTO_MISSING;
    const name = isReduced ? view.reducedFile : view.file;
    await textures.setPhoto(index, photoBlob(name, await file(name)), isReduced ? PHOTO_REDUCED : PHOTO_WHOLE);
  };
  const bake = async (): Promise<void> => {
    if (!isDisposed()) await textures.bake();
  };
  try {
    if (coarseMesh) {
      const [coarse] = await Promise.all([readMesh(coarseMesh), setPhoto(mostCentral(capture))]);
      await setMesh(coarse);
      isShown = true;
      show(capture);
      for (let i = 1; i < VIEWS_BEFORE_MESH && !isDisposed(); i++) {
        await setPhoto(nextView(capture));
        await bake();
      }
    }
    if (coarseMesh?.file !== mesh.file && size.wholeMesh) await setMesh(await readMesh(mesh));
    for (let next = nextView(capture); next >= 0 && !isDisposed(); next = nextView(capture)) await setPhoto(next);
    if (isDisposed()) return capture;
    textures.finish();
    await bake();
    if (isDisposed()) return capture;
    // Without any, it says so.
    if (depthMeshes && (size.depthMeshes || mostBytes === undefined)) {
      const meshes = await loadDepthMeshes(objects, views, file);
      if (isDisposed()) meshes.dispose();
      else {
        textures.setDepthMeshes(meshes);
        disposals.push(meshes.dispose);
      }
    }
  } catch (error) {
    if (!isShown) capture.dispose();
    throw error;
  }
  return capture;
}

/** The photograph to load next: the one that a drawing asks for, else the first of those with the least; -1 if all are whole. */
function nextView({ loaded, wantedView }: CaptureAsset): number {
  if (wantedView >= 0 && loaded[wantedView] !== PHOTO_WHOLE) return wantedView;
  const missing = loaded.indexOf(PHOTO_MISSING);
  return missing >= 0 ? missing : loaded.indexOf(PHOTO_REDUCED);
}

/** The view whose camera is nearest to the middle of all cameras. */
function mostCentral({ positions, viewCount }: CaptureAsset): number {
  const middle = [0, 1, 2].map((axis) => positions.reduce((sum, x, i) => (i % 3 === axis ? sum + x / viewCount : sum), 0));
  const away = (view: number): number => Math.hypot(...middle.map((x, axis) => (positions[3 * view + axis] ?? 0) - x));
  let nearest = 0;
  for (let view = 1; view < viewCount; view++) if (away(view) < away(nearest)) nearest = view;
  return nearest;
}
