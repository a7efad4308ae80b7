import { Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { pictureUrl } from '../../app/cli/rephotograph/photo-pixels.page.ts';
import { compareImages } from '../../export/captures/image-quality.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { loadCapture } from '../../export/runtime/assets/capture/load-capture.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createCaptureDrawing } from '../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import { multiplyMatrices } from '../../nodes/kit/matrices.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import { createGl } from '../browser/scenes-kit.ts';

const SIZE = { widthPx: 320, heightPx: 240 };
const FIELD_OF_VIEW_DEG = 60;

/** What one eye sees. */
export interface Sight {
  readonly psnrDb: number;
  /** The part of the picture that is drawn. */
  readonly covered: number;
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
    setPassState(gl, null, null, 0, 0, widthPx, heightPx);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const target = { framebuffer: null, viewport: { x: 0, y: 0, widthPx, heightPx } };
    drawing.draw(clipFromCapture, Float32Array.from(camera.position.toArray()), Float32Array.from(forward), target);
    const shown = readBack(gl);
    if (gl.getError() !== 0) throw new Error('GL reports an error.');
    const { psnrDb, covered } = compareImages({ shown, truth, widthPx, heightPx });
    return { psnrDb, covered, shown: pictureUrl(shown, widthPx, heightPx), truth: pictureUrl(truth, widthPx, heightPx) };
  });
}

function readBack(gl: WebGL2RenderingContext): Uint8ClampedArray {
  const { widthPx, heightPx } = SIZE;
  const pixels = new Uint8ClampedArray(4 * widthPx * heightPx);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}
