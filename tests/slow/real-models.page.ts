import { AnimationMixer, Box3, DirectionalLight, type Object3D, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand, view } from '../browser/runtime-kit.ts';
import { createGl, readPixels } from '../browser/scenes-kit.ts';

const WIDTH = 192;
const HEIGHT = 192;

/** Of the light in the project: from the right, above and in front. */
export interface Sun {
  readonly azimuthRad: number;
  readonly elevationRad: number;
  readonly intensity: number;
}

/** Draws a model by three's own loader and renderer, and by the player, from the same place in the same light. */
export async function compare(program: Program, baseUrl: string, url: string, timeS: number, sun: Sun) {
  const reference = await drawReference(url, timeS, sun);
  const { pixels, ...drawn } = await drawOurs(program, baseUrl, reference.camera, timeS);
  cameras.set(url, reference.camera);
  return {
    ...difference(reference.pixels, pixels),
    ...drawn,
    sizeM: reference.sizeM,
    ours: [...pixels],
    reference: [...reference.pixels],
    widthPx: WIDTH,
    heightPx: HEIGHT,
  };
}

/** Cameras of the models that `compare` drew, by the URL of the reference. */
const cameras = new Map<string, PerspectiveCamera>();

/** Draws a model by the player alone, with the camera that `compare` used for the reference at `url`. */
export async function drawAgain(program: Program, baseUrl: string, url: string, timeS: number) {
  const camera = cameras.get(url);
  if (!camera) throw new Error(`${url} was not compared before.`);
  const { pixels, ...drawn } = await drawOurs(program, baseUrl, camera, timeS);
  let covered = 0;
  for (let i = 3; i < pixels.length; i += 4) if ((pixels[i] ?? 0) > 0) covered++;
  return { ...drawn, covered, ours: [...pixels] };
}

async function drawOurs(program: Program, baseUrl: string, camera: PerspectiveCamera, timeS: number) {
  const gl = createGl(WIDTH, HEIGHT, { depth: true });
  const fetchFile = (...args: Parameters<typeof fetch>) => fetch(...args);
  const { player, diagnostics } = await stand(program, {
    gl,
    modules: RUNTIMES,
    createScenes: createScenesWith({ decoders: ALL_DECODERS, files: createFetchAssetSource(`${location.href}libs/`, fetchFile).load }),
    assets: createFetchAssetSource(new URL(baseUrl, location.href).href, fetchFile),
  });
  player.setSession({ world: 'image', blend: 'opaque' });
  const seen = view(0, 0, WIDTH, HEIGHT, {
    clipFromView: new Float32Array(camera.projectionMatrix.elements),
    worldFromView: new Float32Array(camera.matrixWorld.elements),
    viewFromWorld: new Float32Array(camera.matrixWorldInverse.elements),
    nearM: camera.near,
    farM: camera.far,
  });
  // Time counts from the first frame on.
  for (const [index, at] of [0, timeS].entries()) {
    player.draw(frame(index, [seen], { timeS: at, framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
  }
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const result = { pixels: readPixels(gl, WIDTH, HEIGHT), diagnostics: diagnostics(), error: gl.getError() };
  player.dispose();
  return result;
}

async function drawReference(url: string, timeS: number, sun: Sun) {
  const { scene: root, animations } = await new GLTFLoader().loadAsync(url);
  const [clip] = animations;
  if (clip) {
    const mixer = new AnimationMixer(root);
    mixer.clipAction(clip).play();
    mixer.setTime(timeS);
  }
  root.updateMatrixWorld(true);
  const sphere = new Box3().setFromObject(root, true).getBoundingSphere(new Sphere());
  const camera = lookAt(sphere);
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const gl = canvas.getContext('webgl2', { antialias: false, preserveDrawingBuffer: true });
  if (!gl) throw new Error('no WebGL 2');
  const renderer = new WebGLRenderer({ canvas, context: gl });
  renderer.setClearColor(0x000000, 0);
  // At 1 a white matt surface is white: its radiance is π of irradiance over π.
  const light = new DirectionalLight(0xffffff, sun.intensity * Math.PI);
  light.position.setFromSphericalCoords(1, Math.PI / 2 - sun.elevationRad, sun.azimuthRad);
  withoutLights(root);
  renderer.render(new Scene().add(root, light), camera);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  renderer.dispose();
  return { pixels, camera, sizeM: sphere.radius * 2 };
}

/** Lights and cameras of a model are not used by Scrim. */
function withoutLights(root: Object3D): void {
  const lights: Object3D[] = [];
  root.traverse((object) => {
    if ('isLight' in object) lights.push(object);
  });
  for (const light of lights) light.removeFromParent();
}

function lookAt({ center, radius }: Sphere): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, radius / 20, radius * 20);
  camera.position.copy(center).add(new Vector3(0.55, 0.4, 1).normalize().multiplyScalar(radius * 2.9));
  camera.lookAt(center);
  camera.updateMatrixWorld();
  return camera;
}

/** Pixels that either covers; the mean of the worst channel's difference over them; the share that differs by more than 24. */
function difference(a: Uint8Array, b: Uint8Array) {
  let covered = 0;
  let onlyOne = 0;
  let sum = 0;
  let far = 0;
  for (let i = 0; i < a.length; i += 4) {
    const isIn = [(a[i + 3] ?? 0) > 0, (b[i + 3] ?? 0) > 0];
    if (isIn[0] || isIn[1]) covered++;
    if (isIn[0] !== isIn[1]) onlyOne++;
    let worst = 0;
    for (let c = 0; c < 3; c++) worst = Math.max(worst, Math.abs((a[i + c] ?? 0) - (b[i + c] ?? 0)));
    sum += worst;
    if (worst > 24) far++;
  }
  return { covered, onlyOne: onlyOne / covered, mean: sum / covered, far: far / covered };
}
