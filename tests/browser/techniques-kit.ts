import {
  Bone,
  BoxGeometry,
  Float32BufferAttribute,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  Quaternion,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { linkTechnique } from '../../export/glsl/technique/link-technique.ts';
import { readTechnique } from '../../export/glsl/technique/read-technique.ts';
import type { Program } from '../../export/program/program.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createImageStore } from '../../export/runtime/gl/image-store.ts';
import type { DrawBinding } from '../../export/runtime/scene-backend.ts';
import { SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { TechniqueUniformView, TechniqueView } from '../../nodes/kit/technique-view.ts';
import { writeHdr } from '../../tools/examples/write-hdr.ts';
import { createStand, drawView, HEIGHT, item, lights, lookingAt, objects, sun, viewOf, WIDTH } from './scenes-kit.ts';

/** Techniques of the library on three.js' objects, drawn by the scene backend without a program. */

export const stand = createStand();

export const EYE = [0, 0, 3] as const;
export const FRONT = lookingAt(EYE, [0, 0, 0]);
export const TOWARDS_SUN = [0.5, 0.4, 1] as const;

export type Values = Readonly<Record<string, number | readonly number[]>>;

/** A technique of the library as the runtime has it, with values other than its defaults. */
export function technique(name: string, values: Values = {}, layers: Layers = {}): TechniqueView {
  return viewOfText(SHADERS[`techniques/${name}.glsl`] ?? '', name, values, layers);
}

/** Decodes what the library's techniques carry; before the first draw with one that carries any. */
export async function loadImages(): Promise<void> {
  const carried = Object.keys(SHADERS).filter((path) => path.startsWith('pictures/'));
  const resource = { kind: 'technique', pictures: carried.map((name) => ({ name, data: SHADERS[name] ?? '' })) };
  await pictures.hold({ resources: [resource] } as unknown as Program).settled;
}

/** Layers at image inputs, pixel-aligned with the view: premultiplied sRGB. */
export type Layers = Readonly<Record<string, WebGLTexture>>;

const pictures = createImageStore(createGlObjects(stand.gl));

export function viewOfText(text: string, key: string, values: Values = {}, layers: Layers = {}): TechniqueView {
  const { output: read, diagnostics } = readTechnique(text, `techniques/${key}.glsl`);
  const { output: linked, diagnostics: wrong } = read
    ? linkTechnique(read, {
        chunkOf: (chunk) => SHADERS[`chunks/${chunk}.glsl`],
        loopBudget: true,
        absent: read.inputs.map(({ name }) => name).filter((name) => !layers[name]),
      })
    : { output: null, diagnostics };
  if (!read || !linked) throw new Error(JSON.stringify(wrong));
  const uniforms = linked.uniforms.map(({ name, param }): TechniqueUniformView => {
    const input = read.inputs.find((one) => one.name === param);
    const value = values[param] ?? input?.default ?? [];
    const numbers = typeof value === 'number' ? [value] : value;
    if (input?.type === 'color') return { name, kind: 'color', view: { value: Float64Array.from(numbers) } };
    if (input?.type === 'point2D') return { name, kind: 'vector', view: { value: Float64Array.from(numbers) } };
    return { name, kind: 'number', view: { value: numbers[0] ?? 0 } };
  });
  if (values.TIME !== undefined) uniforms.push({ name: 'a_TIME', kind: 'number', view: { value: Number(values.TIME) } });
  const placed = { uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1), widthPx: WIDTH, heightPx: HEIGHT };
  const images = [
    ...linked.samplers.map(({ name, input }) => ({ name, at: () => ({ ...placed, texture: layers[input] ?? null }) })),
    ...linked.pictures.map(({ name, path }) => ({ name, at: () => ({ ...placed, texture: pictures.texture(SHADERS[path] ?? '') }) })),
  ];
  const unread = read.unread.flatMap(({ name, input, values: unused }) =>
    linked.uniforms.filter(({ param }) => param === input).map((uniform) => ({ name, uniform: uniform.name, values: unused })),
  );
  return {
    version: 1,
    // Layers that are absent change the shader.
    key: `${key} ${Object.keys(layers)}`,
    vertex: linked.vertex,
    fragment: linked.fragment,
    passes: read.passes,
    uniforms,
    unread,
    images,
  };
}

export function drawnWith(
  root: Object3D,
  view: TechniqueView | null,
  at = new Matrix4(),
  materials: readonly string[] | null = null,
): ObjectItem {
  const made = item(root, { at });
  return view ? Object.assign(made, { techniques: [{ technique: view, materials }] }) : made;
}

export interface Shot {
  readonly items: readonly ObjectItem[];
  readonly suns?: readonly LightItem[];
  readonly occlusion?: DrawBinding['occlusion'];
  readonly camera?: typeof FRONT;
  /** Brightness of the neutral environment. */
  readonly ambient?: number;
}

/** Scenes that were drawn. While they are there, three.js does not compile the shaders of the next ones again. */
const scenes: unknown[] = [];

export function shoot({ items, suns = [sun(TOWARDS_SUN)], occlusion = null, camera = FRONT, ambient = 0 }: Shot): Uint8Array {
  const { backend, layer } = stand;
  const list = objects(...items);
  const lit = lights(...suns);
  const shadowMaps = suns.some((light) => 'shadow' in light && light.shadow !== null) ? backend.createShadowMaps([list], [lit]) : null;
  const scene = backend.serviceFor({ shadowMaps, occlusion }).createScene({ kind: 'shaded', ambient: { value: ambient } });
  scene.update([list], [lit]);
  shadowMaps?.update();
  layer.clear();
  scene.draw(drawView(viewOf(camera), layer.framebuffer));
  const pixels = layer.pixels();
  shadowMaps?.dispose();
  scenes.push(scene);
  return pixels;
}

export const sphere = (color = 0xffffff): Mesh => new Mesh(new SphereGeometry(1, 128, 64), new MeshLambertMaterial({ color }));

/** Where a ray through the middle of the pixel meets the unit sphere. */
export function normalAt(x: number, y: number): Vector3 | null {
  const through = new Vector3(((x + 0.5) / WIDTH) * 2 - 1, ((y + 0.5) / HEIGHT) * 2 - 1, 0.5).unproject(FRONT);
  const eye = new Vector3(...EYE);
  const ray = through.sub(eye).normalize();
  const b = eye.dot(ray);
  const root = b * b - eye.lengthSq() + 1;
  return root < 0 ? null : eye.addScaledVector(ray, -b - Math.sqrt(root));
}

/** A bar of three parts on two bones, the upper one to be bent. */
export function skinned(material: Material): { root: SkinnedMesh; bend: (angle: number) => void } {
  const geometry = new BoxGeometry(0.4, 1.6, 0.4, 1, 8, 1);
  const { position } = geometry.attributes;
  const count = position?.count ?? 0;
  const isUpper = Array.from({ length: count }, (_, i) => ((position?.getY(i) ?? 0) > 0 ? 1 : 0));
  geometry.setAttribute(
    'skinIndex',
    new Uint16BufferAttribute(
      isUpper.flatMap((bone) => [bone, 0, 0, 0]),
      4,
    ),
  );
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      isUpper.flatMap(() => [1, 0, 0, 0]),
      4,
    ),
  );
  const root = new SkinnedMesh(geometry, material);
  const [lower, upper] = [new Bone(), new Bone()];
  lower.add(upper);
  root.add(lower);
  root.updateMatrixWorld(true);
  root.bind(new Skeleton([lower, upper]));
  return { root, bend: (angle) => upper.rotation.set(0, 0, angle) };
}

export function morphing(material: Material): { root: Mesh; bend: (amount: number) => void } {
  const geometry = new SphereGeometry(0.5, 32, 16);
  const positions = [...(geometry.attributes.position?.array ?? [])];
  geometry.morphAttributes.position = [
    new Float32BufferAttribute(
      positions.map((value, i) => (i % 3 === 0 ? value * 2 : value)),
      3,
    ),
  ];
  const root = new Mesh(geometry, material);
  return { root, bend: (amount) => root.morphTargetInfluences?.splice(0, 1, amount) };
}

export function instanced(material: Material): { root: InstancedMesh; bend: (amount: number) => void } {
  const root = new InstancedMesh(new SphereGeometry(0.3, 32, 16), material, 3);
  const place = (amount: number): void => {
    for (let i = 0; i < 3; i++) {
      const scale = new Vector3(1, 1 + amount, 1);
      root.setMatrixAt(i, new Matrix4().compose(new Vector3(i - 1, 0, 0), new Quaternion(), scale));
    }
    root.instanceMatrix.needsUpdate = true;
  };
  place(0);
  return { root, bend: place };
}

/** Pixels that one picture covers and the other does not. */
export function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0;
  for (let at = 3; at < a.length; at += 4) if ((a[at] ?? 0) > 0 !== (b[at] ?? 0) > 0) count++;
  return count;
}

/** A panorama of 64 × 32 pixels, with another color in each direction. */
export function colorful(): ArrayBuffer {
  const rgb: number[] = [];
  for (let y = 0; y < 32; y++)
    for (let x = 0; x < 64; x++) rgb.push(0.5 + 0.4 * Math.sin((x * Math.PI) / 32), 0.9 - y / 40, 0.3 + 0.2 * Math.cos((x * Math.PI) / 32));
  return writeHdr(64, 32, rgb).buffer;
}
