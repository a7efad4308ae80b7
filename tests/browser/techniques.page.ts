import {
  BoxGeometry,
  CylinderGeometry,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  SphereGeometry,
  Vector3,
} from 'three';
import type { LightItem } from '../../nodes/kit/scene-lists.ts';
import { bulb, covered, difference, HEIGHT, item, lookingAt, pixel, project, room, sun, translation, WIDTH } from './scenes-kit.ts';
import {
  colorful,
  differing,
  drawnWith,
  EYE,
  FRONT,
  instanced,
  morphing,
  normalAt,
  shoot,
  skinned,
  sphere,
  stand,
  TOWARDS_SUN,
  technique,
  type Values,
  viewOfText,
} from './techniques-kit.ts';

export interface Sample {
  /** Cosine between normal and light, and between the mirrored light and the eye. */
  readonly facing: number;
  readonly mirrored: number;
  readonly color: readonly number[];
}

/** Colors of an estimated light: that of its strongest lamp, and what comes from everywhere. */
export interface Estimated {
  readonly lamp: readonly number[];
  readonly around: readonly number[];
}

/** Irradiance per coefficient of a constant radiance: Ramamoorthi and Hanrahan 2001, c4 of eq. 12. */
const C4 = 0.886227;

/** A sphere in Gooch's tones, lit by a lamp or as estimated: every third pixel that is well inside. */
export function goochSphere(values: Values, lamp: readonly [number, number, number] | null, estimated: Estimated | null = null) {
  const suns: LightItem[] = lamp ? [bulb(lamp, 40)] : [sun(TOWARDS_SUN)];
  if (estimated) {
    const sphericalHarmonics = new Float32Array(27);
    sphericalHarmonics.set(estimated.around.map((value) => value / C4));
    suns.splice(0, 1, { ...sun(TOWARDS_SUN), radiance: Float32Array.from(estimated.lamp) });
    suns.push({ key: 'around', kind: 'probe', sphericalHarmonics, reflection: null, intensity: 1 });
  }
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

/** The colors of a toon sphere, each with how often it is there, and whether the outline stands around it. */
export function toonSphere(levels: number, outlinePx: number) {
  const values = { levels, outlinePx, outlineColor: [1, 0, 0, 1] };
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
  const middle = HEIGHT / 2;
  const row = Array.from({ length: WIDTH }, (_, x) => pixel(pixels, x, middle).join());
  const widths = [row, row.slice().reverse()].map((half) => half.slice(0, WIDTH / 2).filter((color) => color === '255,0,0,255').length);
  return { colors: [...counts], outside, widths, error: stand.gl.getError() };
}

const OPEN = {
  sheet: () => new PlaneGeometry(1.4, 1),
  /** Half a pipe. Its curved side is a silhouette in some views. */
  gutter: () => new CylinderGeometry(0.6, 0.6, 1.2, 48, 1, true, 0, Math.PI),
};

/** Pixels at the border of an open surface that is turned about the vertical axis, and those of them beside a red outline. */
export function openOutline(style: 'gooch' | 'toon', shape: keyof typeof OPEN, turnRad: number) {
  const root = new Mesh(OPEN[shape](), new MeshLambertMaterial({ side: DoubleSide }));
  const at = new Matrix4().makeRotationX(0.3).multiply(new Matrix4().makeRotationY(turnRad));
  const red = { lineColor: [1, 0, 0, 1], linePx: 2, outlineColor: [1, 0, 0, 1], outlinePx: 2 };
  const pixels = shoot({ items: [drawnWith(root, technique(style, red), at)] });
  const plain = shoot({ items: [item(root, { at })] });
  const isCovered = (x: number, y: number): boolean => (pixel(plain, x, y)[3] ?? 0) > 0;
  const isRed = (x: number, y: number): boolean => pixel(pixels, x, y).join() === '255,0,0,255';
  const around = [-2, -1, 0, 1, 2].flatMap((dy) => [-2, -1, 0, 1, 2].map((dx) => [dx, dy] as const));
  let border = 0;
  let outlined = 0;
  let onIt = 0;
  for (let y = 2; y < HEIGHT - 2; y++) {
    for (let x = 2; x < WIDTH - 2; x++) {
      if (!isCovered(x, y)) continue;
      if (around.every(([dx, dy]) => isCovered(x + dx, y + dy))) {
        if (isRed(x, y)) onIt++;
      } else if (around.some(([dx, dy]) => Math.abs(dx) + Math.abs(dy) === 1 && !isCovered(x + dx, y + dy))) {
        border++;
        if (around.some(([dx, dy]) => isRed(x + dx, y + dy))) outlined++;
      }
    }
  }
  return { border, outlined, onIt, error: stand.gl.getError() };
}

/** Pixels of a room without a roof, seen from outside, and those of them that a red outline covers. */
export function roomOutline(style: 'gooch' | 'toon') {
  const walls = new BoxGeometry(1.6, 1, 1.2);
  // Without the side at the top, and turned inward.
  walls.setIndex(Array.from(walls.getIndex()?.array ?? []).filter((_, i) => Math.floor(i / 6) !== 2));
  const root = new Mesh(walls.scale(-1, 1, 1), new MeshLambertMaterial());
  const at = new Matrix4().makeRotationX(0.5).multiply(new Matrix4().makeRotationY(0.6));
  const red = { lineColor: [1, 0, 0, 1], linePx: 2, outlineColor: [1, 0, 0, 1], outlinePx: 2 };
  const pixels = shoot({ items: [drawnWith(root, technique(style, red), at)] });
  const plain = shoot({ items: [item(root, { at })] });
  const found = { room: 0, covered: 0, error: stand.gl.getError() };
  for (let i = 0; i < plain.length; i += 4) {
    if ((plain[i + 3] ?? 0) < 255) continue;
    found.room++;
    if (pixels.subarray(i, i + 4).join() === '255,0,0,255') found.covered++;
  }
  return found;
}

/** How many pixels a moving object covers, and in how many poses cover others, or its technique others than its own material. */
export function moving(kind: 'skinned' | 'morphing' | 'instanced') {
  const { root, bend } = { skinned, morphing, instanced }[kind](new MeshLambertMaterial());
  const [before, after] = [0, 0.8].map((amount) => {
    bend(amount);
    return {
      own: shoot({ items: [drawnWith(root, null)] }),
      styled: shoot({ items: [drawnWith(root, technique('gooch', { linePx: 0 }))] }),
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
  const pixels = shoot({ items: [drawnWith(wall, technique('toon', { outlinePx: 0 }))], occlusion, camera });
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

/** One box of two materials, the second drawn by name; and a transparent sphere. */
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

const HARMONICS = Float32Array.of(1.1, 0.9, 0.8, 0.3, 0.25, 0.4, -0.1, 0.12, 0.05, 0.2, -0.1, 0.02, ...new Array(15).fill(0));

/** Differences of techniques and three.js' own materials in the light of an environment, and the mean of their bytes. */
export async function environment(kind: 'panorama' | 'estimate' | 'neutral', stops: number) {
  const asset = kind === 'panorama' ? await stand.backend.loadEnvironment(colorful()) : null;
  const intensity = 2 ** stops;
  const suns: LightItem[] = [];
  if (asset) suns.push({ key: 'sky', kind: 'environment', environment: asset, intensity, rotationRad: 0.7, visible: false });
  if (kind === 'estimate') suns.push({ key: 'probe', kind: 'probe', sphericalHarmonics: HARMONICS, reflection: null, intensity });
  const seen = (ball: Mesh, text: string | null): Uint8Array => {
    const view = text ? viewOfText(`/*{ "INPUTS": [] }*/\n${text}`, 'own') : null;
    return shoot({ items: [drawnWith(ball, view)], suns, ambient: kind === 'neutral' ? intensity : 0 });
  };
  const matt = sphere();
  const own = seen(matt, null);
  const metal = new Mesh(new SphereGeometry(1, 128, 64), new MeshStandardMaterial({ metalness: 1, roughness: 0.0525 }));
  const result = {
    matt: difference(own, seen(matt, 'vec4 surface(const in Surface s) { return vec4(IRRADIANCE(s.normal) / 3.14159265, 1.0); }')),
    ambient: difference(own, seen(matt, 'vec4 surface(const in Surface s) { return vec4(AMBIENT, 1.0); }')),
    metal: difference(
      seen(metal, null),
      seen(metal, 'vec4 surface(const in Surface s) { return vec4(REFLECTION(reflect(-s.towardsEye, s.normal), 0.0525), 1.0); }'),
      2,
    ),
    brick: Math.max(
      ...shoot({ items: [drawnWith(matt, technique('brick'))], suns, ambient: kind === 'neutral' ? intensity : 0 }).filter(
        (_, i) => i % 4 < 3,
      ),
    ),
    covered: covered(own),
    matt255: Math.max(...own.filter((_, i) => i % 4 < 3)),
    error: stand.gl.getError(),
  };
  asset?.dispose();
  return result;
}
