import { AnimationMixer, BoxGeometry, type Material, Matrix4, Mesh, MeshStandardMaterial, type Object3D, Vector3 } from 'three';
import type { LoadedModel } from '../../export/runtime/scene-backend.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { trackGl } from '../support/gl-leaks.ts';
import {
  covered,
  createLayer,
  createStand,
  drawView,
  fetchFile,
  HEIGHT,
  item,
  lights,
  loadUrl,
  lookingAt,
  normalizing,
  objects,
  pixel,
  type Stand,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

/** Refuses, from now on, whatever an exported page's policy refuses and a loader might want: `blob:` and `data:` addresses. */
export async function forbidBlobs(): Promise<string> {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  policy.content = "default-src 'none'; connect-src 'self'";
  document.head.append(policy);
  return await fetch(URL.createObjectURL(new Blob(['x']))).then(
    () => 'allowed',
    () => 'refused',
  );
}

function draw({ backend, layer }: Stand, root: Object3D): Uint8Array {
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0.5 } });
  scene.update([objects(item(root, { at: normalizing(root) }))], [lights(sun([0.5, 1, 1]))]);
  layer.clear();
  scene.draw(drawView(viewOf(lookingAt([0.8, 0.6, 2.4], [0, 0, 0])), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

/** Loads a model and draws it; tells what a user would see of it. */
export async function show(url: string) {
  const stand = createStand();
  const model = await loadUrl(stand.backend, url);
  const root = model.instantiate();
  const pixels = draw(stand, root);
  let bright = 0;
  const colors = new Set<number>();
  for (let i = 0; i < pixels.length; i += 4) {
    const [r = 0, g = 0, b = 0] = pixels.subarray(i, i + 3);
    bright = Math.max(bright, r, g, b);
    colors.add((r >> 4) * 256 + (g >> 4) * 16 + (b >> 4));
  }
  model.dispose();
  return { covered: covered(pixels), bright, colors: colors.size, clips: model.clips.map(({ name }) => name), error: stand.gl.getError() };
}

/** What loading these bytes is refused with. */
export async function refusal(url: string, keepBytes: number): Promise<string> {
  const { backend } = createStand();
  const bytes = (await (await fetch(url)).arrayBuffer()).slice(0, keepBytes);
  return await backend.loadModel(bytes, url, fetchFile).then(
    () => 'loaded',
    (error: unknown) => String(error),
  );
}

/** A square in the plane z = 0 with a picture of one pixel, as a `.gltf` with everything in `data:` URLs. */
function embeddedSquare(image: string): ArrayBuffer {
  const positions = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0]);
  const uvs = new Float32Array([0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0]);
  const encode = (array: Float32Array): string =>
    `data:application/octet-stream;base64,${btoa(String.fromCharCode(...new Uint8Array(array.buffer)))}`;
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, extensions: { KHR_materials_unlit: {} } }],
    textures: [{ source: 0 }],
    images: [{ uri: image }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 6, type: 'VEC3', min: [-1, -1, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 6, type: 'VEC2' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 72 },
      { buffer: 1, byteLength: 48 },
    ],
    buffers: [
      { byteLength: 72, uri: encode(positions) },
      { byteLength: 48, uri: encode(uvs) },
    ],
    extensionsUsed: ['KHR_materials_unlit'],
    extensionsRequired: ['KHR_materials_unlit'],
  };
  return new TextEncoder().encode(JSON.stringify(document)).buffer as ArrayBuffer;
}

/** A `.gltf` whose picture is half transparent orange, in an opaque material; and one whose picture is none. */
export async function embedded() {
  const stand = createStand();
  const canvas = document.createElement('canvas');
  canvas.width = 1;
  canvas.height = 1;
  const context = canvas.getContext('2d');
  context?.putImageData(new ImageData(new Uint8ClampedArray([255, 128, 0, 128]), 1, 1), 0, 0);
  const model = await stand.backend.loadModel(embeddedSquare(canvas.toDataURL('image/png')), 'square.gltf', fetchFile);
  const color = pixel(draw(stand, model.instantiate()), WIDTH / 2, HEIGHT / 2);
  model.dispose();
  const broken = await stand.backend.loadModel(embeddedSquare('data:image/png;base64,AAAA'), 'square.gltf', fetchFile).then(
    () => 'loaded',
    (error: unknown) => String(error),
  );
  return { color, broken, error: stand.gl.getError() };
}

/** Two instances of one model share what is big and have bones of their own. */
export async function instances(url: string) {
  const { backend } = createStand();
  const model = await loadUrl(backend, url);
  const [one, other] = [model.instantiate(), model.instantiate()];
  const pose = (root: Object3D, timeS: number): void => {
    const mixer = new AnimationMixer(root);
    const [clip] = model.clips;
    if (clip) mixer.clipAction(clip).play();
    mixer.setTime(timeS);
    root.updateMatrixWorld(true);
  };
  pose(one, 0.2);
  pose(other, 0.6);
  const meshes = (root: Object3D): Mesh[] => {
    const found: Mesh[] = [];
    root.traverse((object) => {
      if ('isMesh' in object) found.push(object as Mesh);
    });
    return found;
  };
  const bones = (root: Object3D): number[] => {
    const places: number[] = [];
    root.traverse((object) => {
      if ('isBone' in object) places.push(...new Vector3().setFromMatrixPosition(object.matrixWorld).toArray());
    });
    return places;
  };
  const shared = meshes(one).every(
    (mesh, i) => mesh.geometry === meshes(other)[i]?.geometry && mesh.material === meshes(other)[i]?.material,
  );
  const [a, b] = [bones(one), bones(other)];
  model.dispose();
  return { shared, apart: Math.max(...a.map((value, i) => Math.abs(value - (b[i] ?? 0)))) };
}

function disposeBones(root: Object3D): void {
  root.traverse((object) => {
    if ('skeleton' in object) (object as unknown as { skeleton: { dispose(): void } }).skeleton.dispose();
  });
}

/** GPU objects before and after many rounds of scenes, shadow maps and models; and of whole backends on one context. */
export async function leaks(urls: readonly string[]) {
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2');
  if (!gl) throw new Error('no WebGL 2');
  const tracker = trackGl(gl);
  const layer = createLayer(gl, WIDTH, HEIGHT);
  const before = { ...tracker.alive() };
  const backend = createScenes({ gl, canvas });
  const round = async (): Promise<void> => {
    const models: LoadedModel[] = [];
    for (const url of urls) models.push(await loadUrl(backend, url));
    const roots = models.map((model) => model.instantiate());
    const list = objects(...roots.map((root, i) => item(root, { at: translation(i - 1, 0, 0).multiply(normalizing(root)) })));
    const floor = objects(...roots.map((root) => item(root, { role: 'phantom', at: new Matrix4() })));
    const sunlight = lights(sun([1, 1, 1], { shadow: { areaM: 5, mapSizePx: 512, bias: 0, normalBiasM: 0.01 } }));
    const maps = backend.createShadowMaps([list], [sunlight]);
    const service = backend.serviceFor({ shadowMaps: maps, occlusion: null });
    const shaded = service.createScene({ kind: 'shaded' });
    const shadow = service.createScene({ kind: 'shadow-catcher', strength: { value: 1 }, color: { value: new Float64Array(4) } });
    for (const scene of [shaded, shadow]) {
      scene.update([list, floor], [sunlight]);
      maps.update();
      layer.clear();
      scene.draw(drawView(viewOf(lookingAt([0, 0, 4], [0, 0, 0])), layer.framebuffer));
    }
    // A list that changes rebuilds its scenes.
    list.items.pop();
    list.version++;
    shaded.update([list], [sunlight]);
    for (const part of [shaded, shadow, maps, ...models]) part.dispose();
    roots.forEach(disposeBones);
  };
  await round();
  const warm = { counts: backend.counts(), alive: { ...tracker.alive() } };
  for (let i = 0; i < 4; i++) await round();
  const later = { counts: backend.counts(), alive: { ...tracker.alive() } };
  backend.dispose();
  for (let i = 0; i < 20; i++) {
    const next = createScenes({ gl, canvas });
    const list = objects(item(mesh(new MeshStandardMaterial())));
    const scene = next.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded' });
    scene.update([list], [lights(sun([0, 1, 0]))]);
    scene.draw(drawView(viewOf(lookingAt([0, 0, 4], [0, 0, 0])), layer.framebuffer));
    scene.dispose();
    disposeMesh(list.items[0]?.root as Mesh);
    next.dispose();
  }
  return { warm, later, before, after: { ...tracker.alive() } };
}

function mesh(material: Material): Mesh {
  return new Mesh(new BoxGeometry(), material);
}

function disposeMesh({ geometry, material }: Mesh): void {
  geometry.dispose();
  for (const part of [material].flat()) part.dispose();
}
