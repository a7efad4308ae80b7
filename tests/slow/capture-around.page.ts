import { Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { compareImages } from '../../export/captures/evaluate/image-quality.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { loadCapture } from '../../export/runtime/assets/capture/load-capture.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createCaptureDrawing } from '../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import { multiplyMatrices } from '../../nodes/kit/matrices.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import { createGl } from '../browser/scenes-kit.ts';
import { pictureUrl } from '../support/photo-pixels.page.ts';

const SIZE = { widthPx: 320, heightPx: 240 };
const FIELD_OF_VIEW_DEG = 60;

/** What one eye sees. */
export interface Sight {
  readonly psnrDb: number;
  /** The part of the picture that is drawn. */
  readonly covered: number;
  /** Pixels that only hidden meshes show: their part of the picture, and their PSNR; that of them in black; that of all others. */
  readonly hidden: { readonly part: number; readonly psnrDb: number; readonly blackDb: number; readonly restDb: number } | null;
  /** Data URLs: what is drawn, and what the model looks like. */
  readonly shown: string;
  readonly truth: string;
}

/**
 * Draws a captured model from several eyes, and compares it with the model itself.
 *
 * @param from Position of the camera in the capture, and in the model.
 * @param eyes Offset in meters, and direction in degrees to the left.
 */
export async function lookAround(
  baseUrl: string,
  modelUrl: string,
  from: { readonly capture: readonly number[]; readonly model: readonly number[] },
  method: 'lumigraph' | 'depth-meshes',
  eyes: readonly { readonly offsetM: readonly [number, number, number]; readonly yawDeg: number }[],
): Promise<readonly Sight[]> {
  const { load } = createFetchAssetSource(new URL(baseUrl, location.href).href, fetch.bind(globalThis));
  const { widthPx, heightPx } = SIZE;
  const gl = createGl(widthPx, heightPx);
  const capture = await loadCapture(createGlObjects(gl), await load('capture.json'), 'capture.json', load, true);
  const drawing = method === 'depth-meshes' ? createDepthMeshDrawing(gl, capture) : createCaptureDrawing(gl, capture, method, 2);
  const { depthMeshes } = capture;
  const withoutHidden = depthMeshes?.hidden ? { ...capture, depthMeshes: { ...depthMeshes, hidden: null } } : null;
  const seen = withoutHidden && method === 'depth-meshes' ? createDepthMeshDrawing(gl, withoutHidden) : null;
  const scene = new Scene();
  const { scene: model } = await new GLTFLoader().loadAsync(new URL(modelUrl, location.href).href);
  model.traverse((object) => {
    const material = object instanceof Mesh ? object.material : null;
    if (material instanceof MeshBasicMaterial) material.toneMapped = false;
  });
  scene.add(model);
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.setPixelRatio(1);
  renderer.setSize(widthPx, heightPx);
  const camera = new PerspectiveCamera(FIELD_OF_VIEW_DEG, widthPx / heightPx, 0.02, 100);
  const clipFromCapture = new Float32Array(16);
  return eyes.map(({ offsetM, yawDeg }) => {
    const place = (origin: readonly number[]): void => {
      camera.position.set(...([0, 1, 2].map((i) => (origin[i] ?? 0) + (offsetM[i] ?? 0)) as [number, number, number]));
      camera.rotation.set(0, (yawDeg * Math.PI) / 180, 0);
      camera.updateMatrixWorld(true);
    };
    place(from.model);
    renderer.render(scene, camera);
    const truth = readBack(renderer.getContext() as WebGL2RenderingContext);
    place(from.capture);
    multiplyMatrices(
      clipFromCapture,
      Float32Array.from(camera.projectionMatrix.elements),
      Float32Array.from(camera.matrixWorldInverse.elements),
    );
    const forward = camera.matrixWorld.elements.slice(8, 11).map((x) => -x);
    const shoot = (by: typeof drawing): Uint8ClampedArray => {
      setPassState(gl, null, null, 0, 0, widthPx, heightPx);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const target = { framebuffer: null, viewport: { x: 0, y: 0, widthPx, heightPx } };
      by.draw(clipFromCapture, Float32Array.from(camera.position.toArray()), Float32Array.from(forward), target);
      return readBack(gl);
    };
    const shown = shoot(drawing);
    const holes = seen && shoot(seen);
    if (gl.getError() !== 0) throw new Error('GL reports an error.');
    const { psnrDb, covered } = compareImages({ shown, truth, widthPx, heightPx });
    const hidden = holes && qualityOfFilled(shown, holes, truth);
    return { psnrDb, covered, hidden, shown: pictureUrl(shown, widthPx, heightPx), truth: pictureUrl(truth, widthPx, heightPx) };
  });
}

/** Compares the pixels that `holes` lacks. Others must be the same. */
function qualityOfFilled(shown: Uint8ClampedArray, holes: Uint8ClampedArray, truth: Uint8ClampedArray): Sight['hidden'] {
  let [square, black, count] = [0, 0, 0];
  const { psnrDb: restDb } = compareImages({ shown: holes, truth, ...SIZE });
  for (let at = 0; at < shown.length; at += 4) {
    if (holes[at + 3] !== 0) {
      if ([0, 1, 2, 3].some((c) => shown[at + c] !== holes[at + c])) throw new Error('A hidden mesh covers what a photograph shows.');
      continue;
    }
    if (shown[at + 3] === 0) continue;
    count++;
    for (let c = 0; c < 3; c++) {
      square += ((shown[at + c] ?? 0) - (truth[at + c] ?? 0)) ** 2;
      black += (truth[at + c] ?? 0) ** 2;
    }
  }
  const toDb = (sum: number): number => 10 * Math.log10((255 * 255) / (sum / (3 * count)));
  return count === 0 ? null : { part: (4 * count) / shown.length, psnrDb: toDb(square), blackDb: toDb(black), restDb };
}

function readBack(gl: WebGL2RenderingContext): Uint8ClampedArray {
  const { widthPx, heightPx } = SIZE;
  const pixels = new Uint8ClampedArray(4 * widthPx * heightPx);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}
