import { BoxGeometry, Matrix4, Mesh, MeshLambertMaterial, PlaneGeometry, Quaternion, SphereGeometry, Vector3 } from 'three';
import { bulb, HEIGHT, lookingAt, pixel, project, room, spot, sun, translation, WIDTH } from '../browser/scenes-kit.ts';
import {
  drawnWith,
  EYE,
  FRONT,
  instanced,
  loadImages,
  morphing,
  shoot,
  skinned,
  sphere,
  stand,
  technique,
  type Values,
} from '../browser/techniques-kit.ts';

const matt = (color = 0xffffff): MeshLambertMaterial => new MeshLambertMaterial({ color });

const noError = (): void => {
  const error = stand.gl.getError();
  if (error !== 0) throw new Error(`GL error ${error}`);
};

/** sRGB to linear of 0 to 255; IEC 61966-2-1. */
function linear(byte: number): number {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

export async function prepare(): Promise<void> {
  await loadImages();
}

/** How bright a plate is on the whole, linear, that faces the eye, in light that comes ever more aslant. */
export function tones(name: string, values: Values, facings: readonly number[]): number[] {
  return facings.map((facing) => tone(name, values, [Math.sqrt(1 - facing * facing), 0, facing], [0, 0, 1]));
}

/** How bright plates with these normals are on the whole, linear, whose light comes aslant. */
export function tonesOfNormals(name: string, values: Values, normals: readonly (readonly [number, number, number])[]): number[] {
  return normals.map((normal) => tone(name, values, [0.8, 0, 0.6], normal));
}

/** The part of the joint between a wall and the top of a ball of bricks that is mortar. */
export function mortarBelowTop(): number {
  // The joint lies where the wall faces the side 0.78 times as much as the top.
  const camera = lookingAt([0, 2.34, 0.78 * 2.34], [0, 0, 0]);
  const values = { variation: 0, bump: 0, mortarM: 0.02, brickM: [0.2, 0.1], brickColor: [0, 0, 0, 1], mortarColor: [1, 1, 1, 1] };
  const pixels = shoot({ items: [drawnWith(sphere(), technique('brick', values))], suns: [], camera, ambient: 1 });
  const row = Array.from({ length: 40 }, (_, i) => pixel(pixels, WIDTH / 2 - 20 + i, HEIGHT / 2)[1] ?? 0);
  noError();
  return row.filter((value) => value > 100).length / row.length;
}

/** The tone of a plate that is turned from facing z to its normal, with the eye and the light. */
function tone(name: string, values: Values, towards: readonly number[], normal: readonly [number, number, number]): number {
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...normal).normalize());
  const turned = (vector: readonly number[]) =>
    new Vector3()
      .fromArray([...vector])
      .applyQuaternion(turn)
      .toArray();
  const plate = new Mesh(new PlaneGeometry(3, 3).applyQuaternion(turn), matt());
  // All corners have the very same normal.
  const normals = plate.geometry.attributes.normal;
  for (let i = 0; i < (normals?.count ?? 0); i++) normals?.setXYZ(i, ...new Vector3(...normal).normalize().toArray());
  const camera = lookingAt(turned(EYE), [0, 0, 0]);
  const pixels = shoot({ items: [drawnWith(plate, technique(name, values))], suns: [sun(turned(towards))], camera });
  let sum = 0;
  let count = 0;
  for (let y = 20; y < HEIGHT - 20; y++) {
    for (let x = 30; x < WIDTH - 30; x++) {
      sum += linear(pixel(pixels, x, y)[1] ?? 0);
      count++;
    }
  }
  noError();
  return sum / count;
}

/** A texture of the size of the view. */
function layer(colorAt: (x: number, y: number) => readonly [number, number, number]): WebGLTexture {
  const { gl } = stand;
  const data = new Uint8Array(WIDTH * HEIGHT * 4);
  for (let y = 0; y < HEIGHT; y++) for (let x = 0; x < WIDTH; x++) data.set([...colorAt(x, y), 255], (y * WIDTH + x) * 4);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, WIDTH, HEIGHT, 0, gl.RGBA, gl.UNSIGNED_BYTE, data);
  for (const parameter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, parameter, gl.NEAREST);
  return texture;
}

const CLEAR = { tint: [1, 1, 1, 1], haze: 0, shine: 0, mirror: 0, dispersion: 0 };

/** A layer whose green is constant, red tells the column and blue the row. */
const encodeAt = (at: number, size: number): number => 25 + Math.round((at * 225) / (size - 1));
const decodeAt = (byte: number, size: number): number => ((byte - 25) * (size - 1)) / 225;

export interface Seen {
  /** Where the pixel is that looks through the ball, from its middle, in radii as seen. */
  readonly at: readonly [number, number];
  /** Cosine between the ball's normal and the eye there. */
  readonly facing: number;
  /** Column and row of the layer that is seen there, and of the one that a ray meets. */
  readonly seen: readonly [number, number];
  readonly traced: readonly [number, number];
}

/**
 * A ball of glass of 1 m before a wall that stands `behindM` from the eye, and what a ray does there by Snell's law, in two
 * steps of plane geometry: it keeps to the plane of the eye, the middle of the ball and itself.
 */
export function throughBall(ior: number, behindM: number): Seen[] {
  const behind = layer((x, y) => [encodeAt(x, WIDTH), 128, encodeAt(y, HEIGHT)]);
  const values = { ...CLEAR, ior, shape: 0, thicknessM: 2, behindM };
  const ball = new Mesh(new SphereGeometry(1, 256, 128), matt());
  const pixels = shoot({ items: [drawnWith(ball, technique('glass', values, { behind }))] });
  noError();
  const rows: Seen[] = [];
  for (let y = 2; y < HEIGHT; y += 5) {
    for (let x = 2; x < WIDTH; x += 5) {
      const through = new Vector3(((x + 0.5) / WIDTH) * 2 - 1, ((y + 0.5) / HEIGHT) * 2 - 1, 0.5).unproject(FRONT);
      const eye = new Vector3(...EYE);
      const ray = through.sub(eye).normalize();
      const traced = traceBall(eye, ray, ior, behindM);
      if (!traced) continue;
      const { hit, facing } = traced;
      const { x: u, y: v } = hit.project(FRONT);
      const where = [(u * 0.5 + 0.5) * WIDTH - 0.5, (v * 0.5 + 0.5) * HEIGHT - 0.5] as const;
      if (facing < 0.3 || where.some((value, i) => value < 1 || value > (i === 0 ? WIDTH : HEIGHT) - 2)) continue;
      // Taking off what the near side reflects leaves the layer's own color.
      const passed = 1 - fresnelByHand(facing, ior);
      const [red = 0, , blue = 0] = pixel(pixels, x, y).map((byte) => encoded(linear(byte) / passed));
      rows.push({ at: [x, y], facing, seen: [decodeAt(red, WIDTH), decodeAt(blue, HEIGHT)], traced: where });
    }
  }
  return rows;
}

/** Angles in the plane of the ray and the middle: in by a, on at b, out by a again, turned by 2 (a - b) in all. */
function traceBall(eye: Vector3, ray: Vector3, ior: number, behindM: number): { hit: Vector3; facing: number } | null {
  const toMiddle = -eye.dot(ray);
  const apart = Math.sqrt(Math.max(eye.lengthSq() - toMiddle * toMiddle, 0));
  if (apart >= 0.999 || apart < 1e-4) return null;
  const a = Math.asin(apart);
  const b = Math.asin(apart / ior);
  const entry = eye.clone().addScaledVector(ray, toMiddle - Math.cos(a));
  // Axes of the plane: along the ray, and from the ray towards the middle.
  const inwards = eye.clone().addScaledVector(ray, toMiddle).negate().normalize();
  const turned = (angle: number): Vector3 => ray.clone().multiplyScalar(Math.cos(angle)).addScaledVector(inwards, Math.sin(angle));
  const exit = entry.clone().addScaledVector(turned(a - b), 2 * Math.cos(b));
  const out = turned(2 * (a - b));
  if (out.z > -0.1) return null;
  const hit = exit.clone().addScaledVector(out, (EYE[2] - behindM - exit.z) / out.z);
  return { hit, facing: Math.cos(a) };
}

/** Of the two polarizations, by the angles themselves. */
export function fresnelByHand(facing: number, ior: number): number {
  const a = Math.acos(facing);
  const b = Math.asin(Math.sin(a) / ior);
  if (a < 1e-4) return ((ior - 1) / (ior + 1)) ** 2;
  const s = Math.sin(a - b) / Math.sin(a + b);
  const p = Math.tan(a - b) / Math.tan(a + b);
  return (s * s + p * p) / 2;
}

function encoded(value: number): number {
  const v = Math.min(Math.max(value, 0), 1);
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
}

/** What part of white passes plates of glass that are turned from the eye: cosine, measured and by hand. */
export function passedByTurnedPlates(ior: number): { facing: number; passed: number; byHand: number }[] {
  const behind = layer(() => [255, 255, 255]);
  const plate = new Mesh(new PlaneGeometry(2, 2), matt());
  return [0, 20, 40, 55, 65, 75].map((degrees) => {
    const turn = (degrees * Math.PI) / 180;
    const item = drawnWith(plate, technique('glass', { ...CLEAR, ior }, { behind }), new Matrix4().makeRotationY(turn));
    const pixels = shoot({ items: [item] });
    noError();
    const through = new Vector3(1 / WIDTH, 1 / HEIGHT, 0.5)
      .unproject(FRONT)
      .sub(new Vector3(...EYE))
      .normalize();
    const facing = -through.dot(new Vector3(Math.sin(turn), 0, Math.cos(turn)));
    return { facing, passed: linear(pixel(pixels, WIDTH / 2, HEIGHT / 2)[1] ?? 0), byHand: 1 - fresnelByHand(facing, ior) };
  });
}

/** Meters between the middles of upright and of level joints on the front of a box, seen straight on, as it stands and moved. */
export function joints(brickM: readonly [number, number]) {
  const values = { brickM, mortarM: 0.03, brickColor: [1, 0, 0, 1], mortarColor: [0, 0, 1, 1], variation: 0, bump: 0 };
  const box = new Mesh(new BoxGeometry(2, 2, 2), matt());
  const at = (place: Matrix4, eye: Vector3) => {
    const camera = lookingAt([eye.x, eye.y, eye.z], [eye.x, eye.y, 0]);
    return { pixels: shoot({ items: [drawnWith(box, technique('brick', values), place)], camera, suns: [sun([0, 0, 1])] }), camera };
  };
  const still = at(new Matrix4(), new Vector3(0.01, 0.01, 2.4));
  const moved = at(translation(0.337, 0.123, 0), new Vector3(0.347, 0.133, 2.4));
  noError();
  const isJoint = (x: number, y: number): boolean => {
    const [red = 0, , blue = 0] = pixel(still.pixels, x, y);
    return blue > red;
  };
  const middlesOf = (is: readonly boolean[]): number[] => {
    const middles: number[] = [];
    for (let from = 0; from < is.length; from++) {
      if (!is[from]) continue;
      let to = from;
      while (is[to + 1]) to++;
      if (from > 0 && to < is.length - 1) middles.push((from + to) / 2);
      from = to;
    }
    return middles;
  };
  const [left] = project(still.camera, [0, 0, 1]);
  const [right] = project(still.camera, [0.5, 0, 1]);
  const perPixel = 0.5 / (right - left);
  const row = (y: number): boolean[] => Array.from({ length: WIDTH }, (_, x) => isJoint(x, y));
  const column = (x: number): boolean[] => Array.from({ length: HEIGHT }, (_, y) => isJoint(x, y));
  const level = middlesOf(column(WIDTH / 2));
  // Half way between two level joints.
  const y = Math.round(((level[0] ?? 0) + (level[1] ?? 0)) / 2);
  const above = Math.round(((level[1] ?? 0) + (level[2] ?? 0)) / 2);
  const upright = middlesOf(row(y));
  const meters = (middles: readonly number[]): number[] => middles.slice(1).map((at, i) => (at - (middles[i] ?? 0)) * perPixel);
  let differing = 0;
  for (let i = 0; i < still.pixels.length; i++) if (Math.abs((still.pixels[i] ?? 0) - (moved.pixels[i] ?? 0)) > 40) differing++;
  const shift = ((middlesOf(row(above))[0] ?? 0) - (upright[0] ?? 0)) * perPixel;
  return { upright: meters(upright), level: meters(level), shift, differing };
}

/** Runs of ink on lines outwards from the middle of a sphere, and pictures at several times. */
export function looseSphere(times: readonly number[]) {
  const shots = times.map((TIME) => {
    const values = {
      loosePx: 9,
      strokePx: 1,
      washColor: [1, 1, 1, 1],
      inkColor: [0, 0, 0, 1],
      rate: 4,
      TIME,
      waveM: 0.5,
      ownColor: 0,
      shade: 0,
    };
    return shoot({ items: [drawnWith(new Mesh(new SphereGeometry(1, 96, 48), matt()), technique('loose-lines', values))] });
  });
  noError();
  const runs: number[] = [];
  for (let angle = 0; angle < 360; angle += 6) {
    let count = 0;
    let inked = false;
    for (let radius = 30; radius < 60; radius++) {
      const x = Math.round(WIDTH / 2 + radius * Math.cos((angle * Math.PI) / 180));
      const y = Math.round(HEIGHT / 2 + radius * Math.sin((angle * Math.PI) / 180));
      const [red = 0, , , alpha = 0] = pixel(shots[0] ?? new Uint8Array(), x, y);
      const ink = alpha > 60 && red < 128;
      if (ink && !inked) count++;
      inked = ink;
    }
    runs.push(count);
  }
  return { runs, same: shots.map((pixels) => pixels.every((value, i) => value === shots[0]?.[i])) };
}

const THROUGH = { haze: 1, shine: 0 };

const SHADOW_PX = { mapSizePx: 1024, biasPx: 2.5 };

/** All throw the plate's shadow over the same place of the floor, and shine beyond it. */
const LIGHTS = {
  sun: () => sun([1, 1, 0], { shadow: { areaM: 5, mapSizePx: 512, bias: 0, normalBiasM: 0.01 } }),
  point: () => bulb([2.1, 2.1, 0], 40, { shadow: SHADOW_PX }),
  spot: () => spot([2.1, 2.1, 0], [0.2, 0, 0], 40, { halfAngleRad: 0.9, shadow: SHADOW_PX }),
} as const;

/**
 * Light that a floor shows in the shadow of a plate, as a part of that beside it; and on a floor that receives none. The lamps' own
 * light falls off, so that the second is not quite one.
 */
export function shadowOn(name: string, kind: keyof typeof LIGHTS): { received: number; refused: number } {
  const camera = lookingAt([0, 3, 0.01], [0, 0, 0]);
  const view = technique(name, name === 'glass' ? THROUGH : {});
  const plate = drawnWith(new Mesh(new PlaneGeometry(0.8, 0.8).rotateX(-Math.PI / 2), matt()), view, translation(0.6, 0.5, 0));
  const [received = 1, refused = 1] = [true, false].map((receives) => {
    const floor = drawnWith(new Mesh(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2), matt()), view);
    floor.receivesShadow = receives;
    const pixels = shoot({ items: [floor, plate], suns: [LIGHTS[kind]()], camera });
    return meanAround(pixels, project(camera, [-0.05, 0, 0])) / meanAround(pixels, project(camera, [-1, 0, 0]));
  });
  noError();
  return { received, refused };
}

/** How bright a floor is under a lamp that shines down on its middle: there, and far off to the side; linear. */
export function underLamp(name: string, kind: 'point' | 'spot'): { middle: number; aside: number } {
  const camera = lookingAt([0, 3, 0.01], [0, 0, 0]);
  const view = technique(name, name === 'glass' ? THROUGH : {});
  const floor = drawnWith(new Mesh(new PlaneGeometry(6, 6).rotateX(-Math.PI / 2), matt()), view);
  const lamp = kind === 'spot' ? spot([0, 1, 0], [0, 0, 0], 3, { halfAngleRad: 0.5 }) : bulb([0, 0.4, 0], 0.5);
  const pixels = shoot({ items: [floor], suns: [lamp], camera });
  noError();
  return { middle: meanAround(pixels, project(camera, [0, 0, 0])), aside: meanAround(pixels, project(camera, [1.4, 0, 0])) };
}

/** Strokes and grain are larger than a pixel. */
function meanAround(pixels: Uint8Array, [x, y]: readonly [number, number]): number {
  let sum = 0;
  for (let dy = -6; dy <= 6; dy++) for (let dx = -6; dx <= 6; dx++) sum += linear(pixel(pixels, x + dx, y + dy)[0] ?? 0);
  return sum;
}

/** A wall whose left half is behind the room: alpha there and beside it. */
export function hidden(name: string): number[] {
  const wall = new Mesh(new PlaneGeometry(9, 9), matt());
  const occlusion = {
    roomDepth: { views: [room(stand.gl, 2, 1, [1.9, 3])] },
    params: { softnessM: { value: 0 }, biasM: { value: 0 } },
  };
  const camera = lookingAt([0, 0, 2], [0, 0, 0]);
  const pixels = shoot({ items: [drawnWith(wall, technique(name, name === 'glass' ? THROUGH : {}))], occlusion, camera });
  noError();
  return [20, 140].map((x) => pixel(pixels, x, HEIGHT / 2)[3] ?? 0);
}

/** Pixels of a moving object's own material that its technique leaves out, in two poses, and those that it covers in one of them only. */
export function moving(name: string, kind: 'skinned' | 'morphing' | 'instanced') {
  const { root, bend } = { skinned, morphing, instanced }[kind](matt());
  const view = technique(name, name === 'glass' ? THROUGH : {});
  const alphas = [0, 0.8].map((amount) => {
    bend(amount);
    return [shoot({ items: [drawnWith(root, null)] }), shoot({ items: [drawnWith(root, view)] })] as const;
  });
  noError();
  const [[own = new Uint8Array(), styled = own] = [], [ownAfter = own, styledAfter = own] = []] = alphas;
  const counts = { missing: 0, moved: 0 };
  for (let at = 3; at < own.length; at += 4) {
    for (const [mine, its] of [
      [own, styled],
      [ownAfter, styledAfter],
    ] as const) {
      if ((mine[at] ?? 0) > 0 && (its[at] ?? 0) === 0) counts.missing++;
    }
    if ((styled[at] ?? 0) > 0 !== (styledAfter[at] ?? 0) > 0) counts.moved++;
  }
  return counts;
}
