import {
  AgXToneMapping,
  DirectionalLight,
  DoubleSide,
  EquirectangularReflectionMapping,
  HalfFloatType,
  Mesh,
  MeshPhysicalMaterial,
  type MeshPhysicalMaterialParameters,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  PMREMGenerator,
  Scene,
  SphereGeometry,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { type Drawn, measureFrames } from './frame-ms.ts';

/**
 * What the scene is drawn to. `display`: the canvas. `scene`: a half-float target, which is tone-mapped to the canvas as in the examples of
 * three.js.
 */
export type LitLayer = 'display' | 'scene';

/**
 * Opens a ball on a floor, lit by a panorama and a sun with shadow, as somebody who knows three.js writes it by hand.
 *
 * @param glass Of the ball, if it is of glass, by three.js' own transmission.
 */
export async function open(
  panoramaUrl: string,
  widthPx: number,
  heightPx: number,
  layer: LitLayer,
  glass: MeshPhysicalMaterialParameters | null = null,
): Promise<void> {
  const renderer = new WebGLRenderer({ antialias: layer === 'display', alpha: true });
  renderer.setSize(widthPx, heightPx, false);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const camera = new PerspectiveCamera(50, widthPx / heightPx, 0.05, 100);
  camera.position.set(0, 1.2, 3);
  camera.lookAt(0, 0.5, 0);

  const scene = new Scene();
  const panorama = await new HDRLoader().loadAsync(panoramaUrl);
  panorama.mapping = EquirectangularReflectionMapping;
  scene.environment = new PMREMGenerator(renderer).fromEquirectangular(panorama).texture;
  const sun = new DirectionalLight(0xffffff, 0.8 * Math.PI);
  sun.position.set(2.4, 3, 2.4);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  Object.assign(sun.shadow.camera, { left: -2.5, right: 2.5, top: 2.5, bottom: -2.5, near: 0.1, far: 12 });
  scene.add(sun);

  const material = { color: 0xcccccc, roughness: 0.6 } as const;
  const ball = new Mesh(new SphereGeometry(0.8, 48, 32), glass ? new MeshPhysicalMaterial(glass) : new MeshStandardMaterial(material));
  const floor = new Mesh(new PlaneGeometry(5, 5).rotateX(-Math.PI / 2), new MeshStandardMaterial({ ...material, side: DoubleSide }));
  shown = ball;
  for (const mesh of [ball, floor]) {
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    scene.add(mesh);
  }
  const gl = renderer.getContext();
  if (layer === 'display') {
    stage = { gl, draw: () => renderer.render(scene, camera) };
    return;
  }
  const linear = new WebGLRenderTarget(widthPx, heightPx, { type: HalfFloatType, samples: 4 });
  const output = new OutputPass();
  output.renderToScreen = true;
  renderer.toneMapping = AgXToneMapping;
  stage = {
    gl,
    draw: () => {
      renderer.setRenderTarget(linear);
      renderer.render(scene, camera);
      output.render(renderer, linear, linear, 0, false);
    },
  };
}

/** The ball as a binary glTF file, for players of such files. */
export async function ballAsModel(): Promise<number[]> {
  if (!shown) throw new Error('Nothing is open.');
  return [...new Uint8Array((await new GLTFExporter().parseAsync(shown, { binary: true })) as ArrayBuffer)];
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage, count);
}

let stage: Drawn | null = null;
let shown: Mesh | null = null;
