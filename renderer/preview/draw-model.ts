import {
  Box3,
  Color,
  DirectionalLight,
  HemisphereLight,
  Matrix4,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector3,
  WebGLRenderer,
} from 'three';
import { measureModel } from '../../export/gltf/measure.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createModelLoader } from '../../export/runtime/scenes/models/load-model.ts';
import type { FromPreview, ToPreview } from '../preview-protocol.ts';
import { previewDecoderFile } from './decoder-files.ts';
import { pageFetch } from './network.ts';

/** Draws pictures of models, one after another. */
export interface ModelDrawer {
  /** Handles a message of the editor. Returns false if it is not for the model drawer. */
  receive(message: ToPreview): boolean;
}

type Asked = Extract<ToPreview, { kind: 'draw-model' }>;

/** Vertical field of view in degrees: a long lens, as product pictures have. */
const FOV_DEG = 28;
/** From the front, a bit from the right and from above. */
const TOWARDS_EYE = new Vector3(0.5, 0.35, 1).normalize();
/** Room around the model. */
const MARGIN = 1.06;

/** Creates the drawer. It makes its GL context with the first picture; the page is closed after the last. */
export function createModelDrawer(send: (message: FromPreview, transfer?: Transferable[]) => void): ModelDrawer {
  let renderer: WebGLRenderer | null = null;
  let last: Promise<void> = Promise.resolve();
  const draw = async ({ request, assetBaseUrl, path, widthPx, heightPx }: Asked) => {
    let gpuBytes: number | null = null;
    try {
      renderer ??= createRenderer();
      renderer.setSize(widthPx, heightPx, false);
      const load = createModelLoader(
        {
          decoders: ALL_DECODERS,
          files: previewDecoderFile,
          inspect: (gltf) => {
            const { geometryBytes, textureBytes } = measureModel(gltf);
            gpuBytes = geometryBytes + textureBytes;
            return [];
          },
        },
        renderer,
      );
      const assets = createFetchAssetSource(assetBaseUrl, pageFetch);
      const model = await load(await assets.load(path), path, (beside) => assets.load(beside));
      drawOnce(renderer, model.instantiate(), widthPx / heightPx);
      const image = await createImageBitmap(renderer.domElement);
      model.dispose();
      send({ kind: 'model-drawn', request, image, gpuBytes }, [image]);
    } catch {
      // The preview and the check of the project say what is wrong with the file.
      send({ kind: 'model-drawn', request, image: null, gpuBytes });
    }
  };
  return {
    receive: (message) => {
      if (message.kind !== 'draw-model') return false;
      last = last.then(() => draw(message));
      return true;
    },
  };
}

function createRenderer(): WebGLRenderer {
  // The picture is copied after the frame.
  return new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
}

function drawOnce(renderer: WebGLRenderer, model: Object3D, aspect: number): void {
  const scene = new Scene();
  const sky = new HemisphereLight(new Color(1, 1, 1), new Color(0.5, 0.48, 0.45), 2.2);
  const sun = new DirectionalLight(new Color(1, 0.97, 0.92), 2.6);
  sun.position.set(0.4, 1, 0.9);
  scene.add(model, sky, sun);
  scene.updateMatrixWorld(true);
  renderer.setClearColor(0, 0);
  renderer.render(scene, framing(model, aspect));
}

/**
 * A camera that shows the whole model as large as it fits: each corner of the bounding box lies inside the frustum.
 *
 * @param aspect Width divided by height of the picture.
 */
function framing(model: Object3D, aspect: number): PerspectiveCamera {
  const box = new Box3().setFromObject(model, true);
  const center = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
  const viewFromWorld = new Matrix4().lookAt(TOWARDS_EYE, new Vector3(), new Vector3(0, 1, 0)).invert();
  const tanY = Math.tan((FOV_DEG * Math.PI) / 360);
  let distance = 0;
  for (let corner = 0; corner < 8; corner++) {
    const at = new Vector3(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z);
    const { x, y, z } = at.sub(center).applyMatrix4(viewFromWorld);
    distance = Math.max(distance, z + Math.abs(y) / tanY, z + Math.abs(x) / (tanY * aspect));
  }
  const usable = Number.isFinite(distance) && distance > 0 ? distance * MARGIN : 1;
  const radius = box.isEmpty() ? 1 : box.getBoundingSphere(new Sphere()).radius;
  const camera = new PerspectiveCamera(FOV_DEG, aspect, Math.max(usable / 100, usable - radius * 2), usable + radius * 2);
  camera.position.copy(center).addScaledVector(TOWARDS_EYE, usable);
  camera.lookAt(center);
  camera.updateMatrixWorld(true);
  return camera;
}
