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
  PlaneGeometry,
  Quaternion,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { linkTechnique } from '../../export/glsl/technique/link-technique.ts';
import { readTechnique } from '../../export/glsl/technique/read-technique.ts';
import type { DrawBinding } from '../../export/runtime/scene-backend.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/runtime.ts';
import type { TechniqueUniformView, TechniqueView } from '../../nodes/kit/technique-view.ts';
import strength from '../../shader-library/chunks/light/strength.glsl';
import gooch from '../../shader-library/techniques/gooch.glsl';
import toon from '../../shader-library/techniques/toon.glsl';
import {
  bulb,
  covered,
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  project,
  room,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const stand = createStand();

const LIBRARY: Readonly<Record<string, string>> = { gooch, toon };
const EYE = [0, 0, 3] as const;
const FRONT = lookingAt(EYE, [0, 0, 0]);
const TOWARDS_SUN = [0.5, 0.4, 1] as const;

type Values = Readonly<Record<string, number | readonly number[]>>;

/** A technique of the library as the runtime has it, with values other than its defaults. */
function technique(name: string, values: Values = {}): TechniqueView {
  return viewOfText(LIBRARY[name] ?? '', name, values);
}

function viewOfText(text: string, key: string, values: Values = {}): TechniqueView {
  const { output: read, diagnostics } = readTechnique(text, `techniques/${key}.glsl`);
  const { output: linked, diagnostics: wrong } = read
    ? linkTechnique(read, { chunkOf: () => strength, loopBudget: true })
    : { output: null, diagnostics };
  if (!read || !linked) throw new Error(JSON.stringify(wrong));
  const uniforms = linked.uniforms.map(({ name, param }): TechniqueUniformView => {
    const input = read.inputs.find((one) => one.name === param);
    const value = values[param] ?? input?.default ?? [];
    const numbers = typeof value === 'number' ? [value] : value;
    if (input?.type === 'color') return { name, kind: 'color', view: { value: Float64Array.from(numbers) } };
    return { name, kind: 'number', view: { value: numbers[0] ?? 0 } };
  });
  return { version: 1, key, vertex: linked.vertex, fragment: linked.fragment, passes: read.passes, uniforms };
}

function drawnWith(root: Object3D, view: TechniqueView | null, at = new Matrix4(), materials: readonly string[] | null = null): ObjectItem {
  const made = item(root, { at });
  return view ? Object.assign(made, { techniques: [{ technique: view, materials }] }) : made;
}

interface Shot {
  readonly items: readonly ObjectItem[];
  readonly suns?: readonly LightItem[];
  readonly occlusion?: DrawBinding['occlusion'];
  readonly camera?: typeof FRONT;
}

function shoot({ items, suns = [sun(TOWARDS_SUN)], occlusion = null, camera = FRONT }: Shot): Uint8Array {
  const { backend, layer } = stand;
  const list = objects(...items);
  const lit = lights(...suns);
  const shadowMaps = suns.some((light) => 'shadow' in light && light.shadow !== null) ? backend.createShadowMaps([list], [lit]) : null;
  const scene = backend.serviceFor({ shadowMaps, occlusion }).createScene({ kind: 'shaded', ambient: { value: 0 } });
  scene.update([list], [lit]);
  shadowMaps?.update();
  layer.clear();
  backend.invalidateState();
  scene.draw(drawView(viewOf(camera), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  shadowMaps?.dispose();
  return pixels;
}

const sphere = (color = 0xffffff): Mesh => new Mesh(new SphereGeometry(1, 128, 64), new MeshLambertMaterial({ color }));

/** Where a ray through the middle of the pixel meets the unit sphere. */
function normalAt(x: number, y: number): Vector3 | null {
  const through = new Vector3(((x + 0.5) / WIDTH) * 2 - 1, ((y + 0.5) / HEIGHT) * 2 - 1, 0.5).unproject(FRONT);
  const eye = new Vector3(...EYE);
  const ray = through.sub(eye).normalize();
  const b = eye.dot(ray);
  const root = b * b - eye.lengthSq() + 1;
  return root < 0 ? null : eye.addScaledVector(ray, -b - Math.sqrt(root));
}

export interface Sample {
  /** Cosine between normal and light, and between the mirrored light and the eye. */
  readonly facing: number;
  readonly mirrored: number;
  readonly color: readonly number[];
}

/** A sphere in Gooch's tones, lit by a lamp: every third pixel that is well inside. */
export function goochSphere(values: Values, lamp: readonly [number, number, number] | null) {
  const suns = lamp ? [bulb(lamp, 40)] : [sun(TOWARDS_SUN)];
  const pixels = shoot({ items: [drawnWith(sphere(0x8080c0), technique('gooch', values))], suns });
  const samples: Sample[] = [];
  for (let y = 0; y < HEIGHT; y += 3) {
    for (let x = 0; x < WIDTH; x += 3) {
      const normal = normalAt(x, y);
      const towardsEye = normal && new Vector3(...EYE).sub(normal).normalize();
      if (!normal || !towardsEye || normal.dot(towardsEye) < 0.15) continue;
      const light = lamp ? new Vector3(...lamp).sub(normal).normalize() : new Vector3(...TOWARDS_SUN).normalize();
      const mirrored = light.clone().negate().reflect(normal).dot(towardsEye);
      samples.push({ facing: normal.dot(light), mirrored: Math.max(mirrored, 0), color: pixel(pixels, x, y) });
    }
  }
  return { samples, error: stand.gl.getError() };
}

/** The colours of a toon sphere, each with how often it is there, and whether the outline stands around it. */
export function toonSphere(levels: number, outlineM: number) {
  const values = { levels, outlineM, outlineColor: [1, 0, 0, 1] };
  const pixels = shoot({ items: [drawnWith(sphere(), technique('toon', values))] });
  const plain = shoot({ items: [item(sphere())] });
  const counts = new Map<string, number>();
  const outside = { outline: 0, other: 0 };
  for (let at = 0; at < pixels.length; at += 4) {
    const color = pixels.subarray(at, at + 4).join();
    if ((plain[at + 3] ?? 0) > 0) counts.set(color, (counts.get(color) ?? 0) + 1);
    else if (color === '255,0,0,255') outside.outline++;
    else if ((pixels[at + 3] ?? 0) > 0) outside.other++;
  }
  return { colors: [...counts], outside, error: stand.gl.getError() };
}

/** A bar of three parts on two bones, the upper one to be bent. */
function skinned(material: Material): { root: SkinnedMesh; bend: (angle: number) => void } {
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

function morphing(material: Material): { root: Mesh; bend: (amount: number) => void } {
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

function instanced(material: Material): { root: InstancedMesh; bend: (amount: number) => void } {
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

/** How many pixels a moving object covers, and in how many poses cover others, or its technique others than its own material. */
export function moving(kind: 'skinned' | 'morphing' | 'instanced') {
  const { root, bend } = { skinned, morphing, instanced }[kind](new MeshLambertMaterial());
  const [before, after] = [0, 0.8].map((amount) => {
    bend(amount);
    return {
      own: shoot({ items: [drawnWith(root, null)] }),
      styled: shoot({ items: [drawnWith(root, technique('gooch'))] }),
    };
  });
  if (!before || !after) throw new Error('There are two poses.');
  return {
    covered: covered(before.styled),
    moved: differing(before.styled, after.styled),
    wrong: differing(before.own, before.styled) + differing(after.own, after.styled),
    error: stand.gl.getError(),
  };
}

/** Pixels that one picture covers and the other does not. */
function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0;
  for (let at = 3; at < a.length; at += 4) if ((a[at] ?? 0) > 0 !== (b[at] ?? 0) > 0) count++;
  return count;
}

/** Normals after skinning: the bent half shades as a box turned by the same angle does. */
export function bentNormals() {
  const { root, bend } = skinned(new MeshLambertMaterial());
  bend(Math.PI / 4);
  const view = technique('gooch', { highlight: 0 });
  const bent = shoot({ items: [drawnWith(root, view)] });
  const turned = new Mesh(new BoxGeometry(0.4, 1.6, 0.4), new MeshLambertMaterial());
  const straight = shoot({ items: [drawnWith(turned, view, new Matrix4().makeRotationZ(Math.PI / 4))] });
  const at = project(FRONT, [-0.3, 0.3, 0.2]);
  return { bent: pixel(bent, ...at), straight: pixel(straight, ...at), error: stand.gl.getError() };
}

/** A white floor under a plate, from above: in the shadow, beside it, and without receiving. */
export function shadowed(receives: boolean) {
  const camera = lookingAt([0, 3, 0.01], [0, 0, 0]);
  const view = technique('gooch', { highlight: 0, coolShare: 0, warmShare: 0, coolColor: [0, 0, 1, 1], warmColor: [1, 1, 0, 1] });
  const floor = drawnWith(new Mesh(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2), new MeshLambertMaterial()), view);
  floor.receivesShadow = receives;
  const plate = item(new Mesh(new PlaneGeometry(0.5, 0.5).rotateX(-Math.PI / 2), new MeshLambertMaterial()), {
    at: translation(0.6, 0.5, 0),
  });
  // Falls 0.5 m to the left on its way down.
  const light = sun([1, 1, 0], { shadow: { areaM: 5, mapSizePx: 1024, bias: 0, normalBiasM: 0.01 } });
  const pixels = shoot({ items: [floor, plate], suns: [light], camera });
  return {
    shadow: pixel(pixels, ...project(camera, [0.1, 0, 0])),
    lit: pixel(pixels, ...project(camera, [-0.8, 0, 0])),
    error: stand.gl.getError(),
  };
}

/** A wall 2 m away in a room whose left half is nearer, with a hard and a soft border: alpha of both halves, and premultiplied red. */
export function occluded(softnessM: number) {
  const wall = new Mesh(new PlaneGeometry(9, 9), new MeshLambertMaterial());
  const camera = lookingAt([0, 0, 2], [0, 0, 0]);
  const depth = room(stand.gl, 2, 1, [1.9, 3]);
  const occlusion = { roomDepth: { views: [depth] }, params: { softnessM: { value: softnessM }, biasM: { value: 0 } } };
  const pixels = shoot({ items: [drawnWith(wall, technique('toon'))], occlusion, camera });
  const own = shoot({ items: [item(wall)], occlusion, camera });
  const halves = (of: Uint8Array) => [20, 140].map((x) => pixel(of, x, HEIGHT / 2));
  return { styled: halves(pixels), own: halves(own).map((color) => color[3]), error: stand.gl.getError() };
}

/** A sphere whose loop never ends by itself. */
export function endless() {
  const text = `/*{ "INPUTS": [] }*/
vec4 surface(const in Surface s) {
  float x = 0.0;
  while (x >= 0.0) x += 1.0;
  return vec4(1.0, 0.0, 0.0, 1.0);
}`;
  const pixels = shoot({ items: [drawnWith(new Mesh(new SphereGeometry(0.2), new MeshLambertMaterial()), viewOfText(text, 'endless'))] });
  return { center: pixel(pixels, WIDTH / 2, HEIGHT / 2), error: stand.gl.getError() };
}

/** One box of two materials, the second drawn by name; and a see-through sphere. */
export function parts() {
  const red = viewOfText('/*{ "INPUTS": [] }*/\nvec4 surface(const in Surface s) { return vec4(1.0, 0.0, 0.0, s.color.a); }', 'red');
  const box = new BoxGeometry(1, 1, 1);
  const green = new MeshLambertMaterial({ color: 0, emissive: 0x00ff00, name: 'Side' });
  const front = new MeshLambertMaterial({ color: 0, emissive: 0x0000ff, name: 'Front' });
  const mesh = new Mesh(box, [green, green, green, green, front, green]);
  const camera = lookingAt([2, 0, 2], [0, 0, 0]);
  const pixels = shoot({ items: [drawnWith(mesh, red, new Matrix4(), ['Front'])], camera });
  const veil = new Mesh(new SphereGeometry(1, 32, 16), new MeshLambertMaterial({ transparent: true, opacity: 0.6 }));
  const seeThrough = shoot({ items: [drawnWith(veil, red)] });
  return {
    front: pixel(pixels, ...project(camera, [0, 0, 0.5])),
    side: pixel(pixels, ...project(camera, [0.5, 0, 0])),
    veil: pixel(seeThrough, WIDTH / 2, HEIGHT / 2),
    error: stand.gl.getError(),
  };
}
