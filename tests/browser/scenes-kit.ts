import { AnimationMixer, Box3, Matrix4, type Object3D, PerspectiveCamera, Sphere, Vector3 } from 'three';
import type { CreateSceneBackend, LoadedModel, SceneBackend } from '../../export/runtime/scene-backend.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { DrawView } from '../../nodes/kit/runtime.ts';
import type {
  DirectionalLightItem,
  LightItem,
  LightList,
  ObjectItem,
  ObjectList,
  PointLightItem,
  SpotLightItem,
} from '../../nodes/kit/scene-lists.ts';
import type { RoomDepth, ViewFrame } from '../../nodes/kit/session.ts';

/** A canvas, a layer to draw into and the scene backend over them: what the player would give, without the player. */

export const WIDTH = 160;
export const HEIGHT = 120;

export interface Stand {
  readonly gl: WebGL2RenderingContext;
  readonly backend: SceneBackend;
  readonly layer: Layer;
}

/** A framebuffer as the player makes them: RGBA8 and 24 bits of depth. */
export interface Layer {
  readonly framebuffer: WebGLFramebuffer;
  readonly color: WebGLTexture;
  readonly depth: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Transparent black, depth 1. */
  clear(): void;
  /** RGBA, bottom row first. */
  pixels(): Uint8Array;
  dispose(): void;
}

export function createGl(widthPx = WIDTH, heightPx = HEIGHT, attributes: WebGLContextAttributes = {}): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  const gl = canvas.getContext('webgl2', { antialias: false, alpha: true, preserveDrawingBuffer: true, ...attributes });
  if (!gl) throw new Error('no WebGL 2');
  return gl;
}

export function createStand(widthPx = WIDTH, heightPx = HEIGHT, createBackend: CreateSceneBackend = createScenes): Stand {
  const gl = createGl(widthPx, heightPx);
  const backend = createBackend({ gl, canvas: gl.canvas });
  return { gl, backend, layer: createLayer(gl, widthPx, heightPx) };
}

export function createLayer(gl: WebGL2RenderingContext, widthPx: number, heightPx: number): Layer {
  const store = (format: GLenum): WebGLTexture => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, widthPx, heightPx);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    return texture;
  };
  const color = store(gl.RGBA8);
  const depth = store(gl.DEPTH_COMPONENT24);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
  return {
    framebuffer,
    color,
    depth,
    widthPx,
    heightPx,
    clear: () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.disable(gl.SCISSOR_TEST);
      gl.colorMask(true, true, true, true);
      gl.depthMask(true);
      gl.clearColor(0, 0, 0, 0);
      gl.clearDepth(1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    },
    pixels: () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      return readPixels(gl, widthPx, heightPx);
    },
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(color);
      gl.deleteTexture(depth);
    },
  };
}

/** Of the bound framebuffer; bottom row first. */
export function readPixels(gl: WebGL2RenderingContext, widthPx: number, heightPx: number): Uint8Array {
  gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
  const pixels = new Uint8Array(widthPx * heightPx * 4);
  gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** A camera at `eye` looking at `target`, 50° high, near 0.1 m, far 50 m. */
export function lookingAt(
  eye: readonly [number, number, number],
  target: readonly [number, number, number],
  aspect = WIDTH / HEIGHT,
): PerspectiveCamera {
  const camera = new PerspectiveCamera(50, aspect, 0.1, 50);
  camera.position.set(...eye);
  camera.lookAt(...target);
  camera.updateMatrixWorld();
  return camera;
}

/** The view of a camera, in a part of a framebuffer. */
export function viewOf(camera: PerspectiveCamera, viewport = { x: 0, y: 0, widthPx: WIDTH, heightPx: HEIGHT }): ViewFrame {
  return {
    eye: 'none',
    clipFromView: new Float32Array(camera.projectionMatrix.elements),
    worldFromView: new Float32Array(camera.matrixWorld.elements),
    viewFromWorld: new Float32Array(camera.matrixWorldInverse.elements),
    nearM: camera.near,
    farM: camera.far,
    viewport,
    cameraImage: null,
    depth: null,
  };
}

export function drawView(view: ViewFrame, framebuffer: WebGLFramebuffer | null, viewIndex = 0): DrawView {
  return { view, viewIndex, framebuffer, viewport: view.viewport };
}

export interface ItemOptions {
  readonly at?: Matrix4;
  readonly role?: ObjectItem['role'];
  readonly castsShadow?: boolean;
  readonly receivesShadow?: boolean;
}

export function item(root: Object3D, options: ItemOptions = {}): ObjectItem {
  root.updateMatrixWorld(true);
  return {
    key: root.uuid,
    root,
    worldFromObject: options.at ?? new Matrix4(),
    role: options.role ?? 'virtual',
    castsShadow: options.castsShadow ?? true,
    receivesShadow: options.receivesShadow ?? true,
  };
}

export function objects(...items: ObjectItem[]): ObjectList {
  return { version: 1, items };
}

export function sun(
  towards: readonly [number, number, number],
  options: { shadow?: DirectionalLightItem['shadow']; radiance?: number } = {},
): DirectionalLightItem {
  const { x, y, z } = new Vector3(...towards).normalize();
  return {
    key: 'sun',
    kind: 'directional',
    radiance: new Float32Array(3).fill(options.radiance ?? Math.PI),
    towardsLightWorld: new Float32Array([x, y, z]),
    shadow: options.shadow ?? null,
  };
}

/** White, of so many candela. */
export function bulb(positionWorld: readonly [number, number, number], cd: number, more: Partial<PointLightItem> = {}): PointLightItem {
  return {
    key: 'bulb',
    kind: 'point',
    intensityCd: new Float32Array(3).fill(cd),
    positionWorld: new Float32Array(positionWorld),
    rangeM: 0,
    shadow: null,
    ...more,
  };
}

/** The same in a cone of 60 degrees with a sharp edge, aimed at a point. */
export function spot(
  positionWorld: readonly [number, number, number],
  targetWorld: readonly [number, number, number],
  cd: number,
  more: Partial<SpotLightItem> = {},
): SpotLightItem {
  return {
    key: 'spot',
    kind: 'spot',
    intensityCd: new Float32Array(3).fill(cd),
    positionWorld: new Float32Array(positionWorld),
    towardsLightWorld: new Float32Array(
      new Vector3(...positionWorld)
        .sub(new Vector3(...targetWorld))
        .normalize()
        .toArray(),
    ),
    rangeM: 0,
    halfAngleRad: Math.PI / 6,
    penumbra: 0,
    shadow: null,
    ...more,
  };
}

export function lights(...items: LightItem[]): LightList {
  return { version: 1, items };
}

export function translation(x: number, y: number, z: number): Matrix4 {
  return new Matrix4().makeTranslation(x, y, z);
}

/** RGBA of the pixel, origin bottom left. */
export function pixel(pixels: Uint8Array, x: number, y: number, widthPx = WIDTH): number[] {
  const at = (y * widthPx + x) * 4;
  return [...pixels.subarray(at, at + 4)];
}

/** Where a world point lands: pixels, origin bottom left. */
export function project(camera: PerspectiveCamera, point: readonly [number, number, number]): [number, number] {
  const { x, y } = new Vector3(...point).project(camera);
  return [Math.floor((x * 0.5 + 0.5) * WIDTH), Math.floor((y * 0.5 + 0.5) * HEIGHT)];
}

/** How far apart two pictures are: pixels that differ by more than `tolerance`, and the largest difference. */
export function difference(a: Uint8Array, b: Uint8Array, tolerance = 1): { pixels: number; largest: number } {
  let pixels = 0;
  let largest = 0;
  for (let at = 0; at < a.length; at += 4) {
    let worst = 0;
    for (let c = 0; c < 4; c++) worst = Math.max(worst, Math.abs((a[at + c] ?? 0) - (b[at + c] ?? 0)));
    if (worst > tolerance) pixels++;
    largest = Math.max(largest, worst);
  }
  return { pixels, largest };
}

/** Pixels with any alpha. */
export function covered(pixels: Uint8Array): number {
  let count = 0;
  for (let at = 3; at < pixels.length; at += 4) if ((pixels[at] ?? 0) > 0) count++;
  return count;
}

/** Scales and moves a model into the unit sphere around the origin. */
export function normalizing(root: Object3D): Matrix4 {
  root.updateMatrixWorld(true);
  const sphere = new Box3().setFromObject(root, true).getBoundingSphere(new Sphere());
  const scale = 1 / sphere.radius;
  return new Matrix4().makeScale(scale, scale, scale).multiply(translation(-sphere.center.x, -sphere.center.y, -sphere.center.z));
}

/** Reads a file beside the page. */
export async function fetchFile(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response.arrayBuffer();
}

export async function loadUrl(backend: SceneBackend, url: string): Promise<LoadedModel> {
  return await backend.loadModel(await fetchFile(url), url, fetchFile);
}

const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Room depth as sessions give it: meters per texel, bottom row first, 0 where unknown. */
export function room(gl: WebGL2RenderingContext, widthPx: number, heightPx: number, meters: number[], uvFromViewUv = IDENTITY): RoomDepth {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, widthPx, heightPx, 0, gl.RED, gl.FLOAT, new Float32Array(meters));
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  return { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(uvFromViewUv), worldFromDepth: new Float32Array(16) };
}

/** A model in the midst of its first clip, and where it is to stand so that it is 0.45 m large, beside the middle and above the floor. */
export function midStride(model: LoadedModel): { readonly root: Object3D; readonly at: Matrix4 } {
  const root = model.instantiate();
  const mixer = new AnimationMixer(root);
  const [clip] = model.clips;
  if (clip) mixer.clipAction(clip).play();
  mixer.setTime(0.4);
  root.updateMatrixWorld(true);
  const at = normalizing(root)
    .premultiply(new Matrix4().makeScale(0.45, 0.45, 0.45))
    .premultiply(translation(-0.3, 0.5, 0));
  return { root, at };
}
