import { AnimationMixer, type Object3D } from 'three';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import {
  covered,
  createStand,
  drawView,
  fetchFile,
  item,
  lights,
  loadUrl,
  lookingAt,
  normalizing,
  objects,
  type Stand,
  sun,
  viewOf,
} from './scenes-kit.ts';

/** As an exported page's policy is where models need decoders. */
export async function applyPolicy(): Promise<string> {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  policy.content = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; connect-src 'self'";
  document.head.append(policy);
  return await fetch(URL.createObjectURL(new Blob(['x']))).then(
    () => 'allowed',
    () => 'refused',
  );
}

const SIZE = 256;

function stand(): Stand {
  const createBackend = createScenesWith({ decoders: ALL_DECODERS, files: (file) => fetchFile(`/libs/${file}`) });
  return createStand(SIZE, SIZE, createBackend);
}

/** What a designer can refer to, and what makes a model move. */
interface Facts {
  readonly names: readonly string[];
  readonly clips: readonly string[];
  readonly bones: number;
  readonly morphs: number;
  readonly packedTextures: number;
}

async function show(place: Stand, url: string, clip: string | null, timeS: number): Promise<{ pixels: Uint8Array; facts: Facts }> {
  const model = await loadUrl(place.backend, url);
  const root = model.instantiate();
  const at = normalizing(root);
  const wanted = model.clips.find(({ name }) => name === clip);
  if (wanted) {
    const mixer = new AnimationMixer(root);
    mixer.clipAction(wanted).play();
    mixer.setTime(timeS);
    root.updateMatrixWorld(true);
  }
  const { backend, layer } = place;
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0.5 } });
  scene.update([objects(item(root, { at }))], [lights(sun([0.5, 1, 1]))]);
  layer.clear();
  const view = viewOf(lookingAt([0.8, 0.6, 2.4], [0, 0, 0], 1), { x: 0, y: 0, widthPx: SIZE, heightPx: SIZE });
  scene.draw(drawView(view, layer.framebuffer));
  const pixels = layer.pixels();
  const facts = factsOf(
    root,
    model.clips.map(({ name }) => name),
  );
  scene.dispose();
  model.dispose();
  return { pixels, facts };
}

function factsOf(root: Object3D, clips: readonly string[]): Facts {
  const names = new Set<string>();
  const textures = new Set<unknown>();
  let bones = 0;
  let morphs = 0;
  root.traverse((object) => {
    if (object.name !== '') names.add(object.name);
    if ('isBone' in object) bones++;
    if ('morphTargetInfluences' in object && object.morphTargetInfluences) morphs += (object.morphTargetInfluences as number[]).length;
    if (!('material' in object)) return;
    for (const value of Object.values(object.material as object)) {
      if (typeof value === 'object' && value !== null && 'isCompressedTexture' in value) textures.add(value.source);
    }
  });
  return { names: [...names].sort(), clips: [...clips].sort(), bones, morphs, packedTextures: textures.size };
}

/** Draws two models in the same place; tells how much their pictures differ, over the pixels that either covers. */
export async function compare(original: string, other: string, clip: string | null = null, timeS = 0) {
  const place = stand();
  const a = await show(place, original, clip, timeS);
  const b = await show(place, other, clip, timeS);
  const size = covered(a.pixels);
  let sum = 0;
  let far = 0;
  for (let i = 0; i < a.pixels.length; i += 4) {
    let worst = 0;
    for (let c = 0; c < 4; c++) worst = Math.max(worst, Math.abs((a.pixels[i + c] ?? 0) - (b.pixels[i + c] ?? 0)));
    sum += worst;
    if (worst > 24) far++;
  }
  const error = place.gl.getError();
  place.backend.dispose();
  return { covered: size, mean: sum / size, far: far / size, before: a.facts, after: b.facts, error };
}

/** What loading a model is refused with. */
export async function refusal(url: string): Promise<string> {
  const { backend } = stand();
  return await loadUrl(backend, url).then(
    () => 'loaded',
    (error: unknown) => String(error),
  );
}
