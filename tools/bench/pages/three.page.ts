import {
  Color,
  DirectionalLight,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  ShaderMaterial,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { FullScreenQuad } from 'three/addons/postprocessing/Pass.js';
import { type Drawn, measureFrames } from './frame-ms.ts';
import { addRobots, createFloor, type Standing } from './robots-on-floor.ts';

/**
 * Opens the first example, or a template, as somebody who knows three.js writes it by hand: the same model at the same places, light,
 * shadow and floor. `filtered` adds a filter that warms the image. Benches compare its frames with those of Scrim, and the size of its
 * script with that of an exported page.
 */
export async function open(
  modelUrl: string,
  widthPx: number,
  heightPx: number,
  robots: readonly Standing[],
  filtered: boolean,
): Promise<void> {
  const renderer = new WebGLRenderer({ antialias: !filtered, alpha: true });
  renderer.setSize(widthPx, heightPx, false);
  renderer.xr.enabled = true;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;

  const camera = new PerspectiveCamera(50, widthPx / heightPx, 0.05, 100);
  camera.position.set(0, 1.2, 3);
  camera.lookAt(0, 0.5, 0);

  const scene = new Scene();
  scene.add(new HemisphereLight(0xffffff, 0xffffff, 0.35 * Math.PI));
  const sun = new DirectionalLight(new Color(1, 0.94, 0.85), 0.85 * Math.PI);
  sun.position.set(-2.4, 1.7, 0.6);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  Object.assign(sun.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.1, far: 8 });
  scene.add(sun);

  scene.add(createFloor());

  const gltf = await new GLTFLoader().loadAsync(modelUrl);
  const mixers = addRobots(scene, gltf, robots);

  const render = filtered ? throughFilter(renderer, scene, camera, widthPx, heightPx) : () => renderer.render(scene, camera);
  stage = {
    gl: renderer.getContext(),
    draw: (deltaS) => {
      for (const mixer of mixers) mixer.update(deltaS);
      render();
    },
  };
}

/**
 * Returns a function that renders the scene through a filter as the examples of three.js do: to a target with four samples, which a
 * full-screen triangle draws.
 */
function throughFilter(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera, widthPx: number, heightPx: number): () => void {
  const picture = new WebGLRenderTarget(widthPx, heightPx, { samples: 4 });
  const screen = new FullScreenQuad(
    new ShaderMaterial({
      uniforms: { picture: { value: picture.texture } },
      vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `uniform sampler2D picture; varying vec2 at;
        void main() { gl_FragColor = texture2D(picture, at) * vec4(1.05, 1.0, 0.9, 1.0); }`,
    }),
  );
  return () => {
    renderer.setRenderTarget(picture);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    screen.render(renderer);
  };
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage, count);
}

let stage: Drawn | null = null;
