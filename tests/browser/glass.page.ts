import {
  Color,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  type MeshPhysicalMaterialParameters,
  MeshStandardMaterial,
  PlaneGeometry,
  Raycaster,
  Sphere,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three';
import type { DrawView, UnderLayer } from '../../nodes/kit/runtime.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import { cube, HARMONICS } from './light-estimate.page.ts';
import {
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  room,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';
import { colorful, drawnWith, technique } from './techniques-kit.ts';

/** Scenes with glass, drawn by the backend without a program. Pictures are RGBA, bottom row first. */

const stand = createStand();
export const FRONT = lookingAt([0, 0, 2], [0, 0, 0]);
const IDENTITY = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

interface Shot {
  readonly under?: UnderLayer | undefined;
  readonly occlusion?: { readonly depthM: number; readonly softnessM?: number } | null;
  /** The color that the layer has before. */
  readonly clear?: readonly [number, number, number, number];
  readonly light?: boolean;
  readonly lamps?: readonly LightItem[];
}

export function shoot(
  items: readonly ObjectItem[],
  { under, occlusion = null, clear, light = false, lamps = light ? [sun([0.3, 1, 0.5])] : [] }: Shot = {},
): Uint8Array {
  const { gl, backend, layer } = stand;
  const depth = occlusion && { views: [room(gl, 2, 1, [occlusion.depthM, 9])] };
  const hiding = depth && {
    roomDepth: depth,
    params: { softnessM: { value: occlusion?.softnessM ?? 0 }, biasM: { value: 0 }, borderPx: { value: 0 } },
  };
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: hiding }).createScene({ kind: 'shaded', ambient: { value: 0 } });
  scene.update([objects(...items)], lamps.length > 0 ? [lights(...lamps)] : []);
  layer.clear();
  if (clear) {
    gl.clearColor(...clear);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }
  const view: DrawView = { ...drawView(viewOf(FRONT), layer.framebuffer), ...(under ? { under } : {}) };
  scene.draw(view);
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

/** A picture of the size of the view as what is under the layer. */
export function imageUnder(paint: (x: number, y: number) => readonly number[], isInTarget = false): UnderLayer {
  const { gl } = stand;
  const texture = gl.createTexture();
  const bytes = new Uint8Array(WIDTH * HEIGHT * 4);
  for (let y = 0; y < HEIGHT; y++) for (let x = 0; x < WIDTH; x++) bytes.set(paint(x, y), (y * WIDTH + x) * 4);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, WIDTH, HEIGHT, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  return { texture, uvFromViewUv: IDENTITY, encoding: 'display', color: null, isInTarget };
}

const checks =
  (sizePx: number) =>
  (x: number, y: number): number[] =>
    (Math.floor(x / sizePx) + Math.floor(y / sizePx)) % 2 === 0 ? [255, 255, 255, 255] : [0, 0, 0, 255];

export function glass(options: MeshPhysicalMaterialParameters = {}): MeshPhysicalMaterial {
  return new MeshPhysicalMaterial({ transmission: 1, roughness: 0, ...options });
}

/** A pane that fills the picture, 1.5 m before the camera. */
function pane(options: MeshPhysicalMaterialParameters = {}, at = 0.5): ObjectItem {
  return item(new Mesh(new PlaneGeometry(9, 9), glass(options)), { at: translation(0, 0, at) });
}

export function sheet(material: Material, x: number, y: number, z: number, widthM: number, heightM = widthM): ObjectItem {
  return item(new Mesh(new PlaneGeometry(widthM, heightM), material), { at: translation(x, y, z) });
}

export const flat = (color: number): MeshBasicMaterial => new MeshBasicMaterial({ color });

/** The largest difference between a noise and what a clear pane of index 1 shows of it. */
export function clearPane() {
  let state = 7;
  const noise = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 24;
  };
  const bytes = Uint8Array.from({ length: WIDTH * HEIGHT * 4 }, (_, i) => (i % 4 === 3 ? 255 : noise()));
  const under = imageUnder((x, y) => [...bytes.subarray((y * WIDTH + x) * 4, (y * WIDTH + x) * 4 + 4)]);
  const pixels = shoot([pane({ ior: 1, thickness: 0 })], { under });
  let largest = 0;
  for (let i = 0; i < pixels.length; i++) largest = Math.max(largest, Math.abs((pixels[i] ?? 0) - (bytes[i] ?? 0)));
  return { largest, error: stand.gl.getError() };
}

/** Width in pixels over which an edge seen through a pane rises from 10 to 90 %, in linear light. */
export function edgeWidths(roughnesses: readonly number[]) {
  const under = imageUnder(checks(WIDTH / 2));
  return roughnesses.map((roughness) => {
    const pixels = shoot([pane({ ior: 1.5, thickness: 0, roughness })], { under });
    const row = Array.from({ length: WIDTH }, (_, x) => linear(pixel(pixels, x, HEIGHT / 4)[0] ?? 0));
    const low = Math.min(...row);
    const high = Math.max(...row);
    const inside = row.filter((value) => value > low + 0.1 * (high - low) && value < high - 0.1 * (high - low));
    return inside.length;
  });
}

function linear(byte: number): number {
  const v = byte / 255;
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
}

/** The middle of a pane with a volume over white, and over nothing of an index of 1, so that it mirrors nothing. */
export function attenuated(thickness: number, attenuationDistance: number, color: readonly [number, number, number], scale = 1) {
  const attenuationColor = new Color().setRGB(...color);
  const under = imageUnder(() => [255, 255, 255, 255]);
  const part = new Mesh(new PlaneGeometry(9, 9), glass({ ior: 1, specularIntensity: 0, thickness, attenuationDistance, attenuationColor }));
  const at = translation(0, 0, 0.5).multiply(new Matrix4().makeScale(scale, scale, scale));
  return pixel(shoot([item(part, { at })], { under }), WIDTH / 2, HEIGHT / 2);
}

/** Red and blue columns of a white line that a ball of glass shows, left of its middle. */
export function dispersed(dispersion: number) {
  const white = sheet(flat(0xffffff), -0.25, 0, -1, 0.1, 4);
  const black = sheet(flat(0x000000), 0, 0, -1.1, 9);
  const ball = item(new Mesh(new SphereGeometry(0.6, 64, 32), glass({ ior: 1.5, thickness: 0.8, dispersion })), {});
  const pixels = shoot([white, black, ball]);
  const center = (channel: number): number => {
    let sum = 0;
    let weight = 0;
    for (let x = WIDTH / 2 - 45; x < WIDTH / 2 + 45; x++) {
      const value = linear(pixel(pixels, x, HEIGHT / 2)[channel] ?? 0);
      sum += x * value;
      weight += value;
    }
    return sum / weight;
  };
  return { red: center(0), green: center(1), blue: center(2) };
}

/** Panes before a sheet, one before the other: what each shows. The nearer is seen right, the farther left of the middle. */
export function stacked(nearFirst: boolean) {
  const far = sheet(glass({ color: 0x80ff80, ior: 1, specularIntensity: 0 }), -0.2, 0, 0, 0.8);
  const near = sheet(glass({ color: 0xff8080, ior: 1, specularIntensity: 0 }), 0.2, 0, 0.3, 0.8);
  const veil = sheet(new MeshBasicMaterial({ color: 0x0000ff, transparent: true, opacity: 0.5 }), 0, 0.3, 0.15, 3, 0.3);
  const white = sheet(flat(0xffffff), 0, 0, -1, 9);
  const pixels = shoot(nearFirst ? [near, veil, white, far] : [far, white, veil, near]);
  const at = (x: number, y: number): number[] => pixel(pixels, WIDTH / 2 + x, HEIGHT / 2 + y);
  return { white: at(-75, 0), far: at(-32, 0), both: at(0, 0), near: at(38, 0), veilThroughNear: at(38, 20), veil: at(-75, 20) };
}

/** A ball before a virtual quarter: what it shows, and what is drawn beside it. */
export function ballBeforeSheet(asTransparentLayer: boolean) {
  const left = sheet(flat(0xff0000), -1.5, 0, -1, 3, 9);
  const right = sheet(flat(0x0000ff), 1.5, 0, -1, 3, 9);
  const ball = item(new Mesh(new SphereGeometry(0.5, 64, 32), glass({ ior: 1.5, thickness: 1.6, specularIntensity: 0 })), {});
  const pixels = shoot(asTransparentLayer ? [left, ball] : [left, right, ball]);
  const at = (x: number): number[] => pixel(pixels, WIDTH / 2 + x, HEIGHT / 2);
  return { rims: [at(-32), at(31)], beside: [at(-60), at(60)], error: stand.gl.getError() };
}

/** Glass over a drawn room with an object straight behind: seen through it, hidden by the room, and at a soft border. */
export function overRoom() {
  const under = imageUnder((x) => (x < WIDTH / 2 ? [200, 0, 0, 255] : [0, 0, 200, 255]), true);
  const clear = [0, 0.5, 0, 1] as const;
  const thick = { ior: 1, specularIntensity: 0, thickness: 0 };
  const box = sheet(flat(0xffffff), 0.5, 0, 0, 0.4);
  const open = shoot([pane(thick), box], { under, clear });
  const hidden = shoot([pane(thick), box], { under, clear, occlusion: { depthM: 1 } });
  const soft = shoot([pane(thick), box], { under, clear, occlusion: { depthM: 1.25, softnessM: 0.5 } });
  const at = (pixels: Uint8Array, x: number): number[] => pixel(pixels, WIDTH / 2 + x, HEIGHT / 2);
  return { room: at(open, -40), object: at(open, 32), hidden: at(hidden, -40), besideHidden: at(hidden, 70), soft: at(soft, -40) };
}

/** The light of a room as a device measures it, as a panorama that was taken of it, and as coefficients from the mean of its image. */
async function lightOf(room: Room): Promise<LightItem> {
  if (room === 'panorama') {
    const environment = await stand.backend.loadEnvironment(colorful());
    return { key: 'taken', kind: 'environment', environment, intensity: 1, rotationRad: 0.7, visible: false };
  }
  const reflection = room === 'cube' ? cube(stand.gl, 1) : null;
  return { key: 'around', kind: 'probe', sphericalHarmonics: HARMONICS, reflection, intensity: 1 };
}

export type Room = 'cube' | 'panorama' | 'coefficients';

const BALL_M = 0.6;

/**
 * What a ball of glass before black shows at each pixel, in linear light: with the cosine between its normal and the eye, and what a
 * perfect mirror of three.js shows there.
 */
export async function mirrored(room: Room, kind: 'technique' | 'model', ior: number) {
  const lamps = [await lightOf(room)];
  const black = sheet(flat(0), 0, 0, -1.1, 9);
  const ball = (material: Material): Mesh => new Mesh(new SphereGeometry(BALL_M, 192, 96), material);
  const pure = { ior, thicknessM: 0.3, shine: 0, haze: 0, dispersion: 0 };
  const clear = kind === 'model' ? item(ball(glass({ ior }))) : drawnWith(ball(flat(0xffffff)), technique('glass', pure));
  const seen = shoot([black, clear], { lamps });
  const mirror = shoot([black, item(ball(new MeshStandardMaterial({ metalness: 1, roughness: 0 })))], { lamps });
  const caster = new Raycaster();
  const at = new Vector3();
  const samples: { cosine: number; seen: number[]; mirror: number[] }[] = [];
  for (let y = 0; y < HEIGHT; y += 2) {
    for (let x = 0; x < WIDTH; x += 2) {
      caster.setFromCamera(new Vector2(((x + 0.5) / WIDTH) * 2 - 1, ((y + 0.5) / HEIGHT) * 2 - 1), FRONT);
      if (!caster.ray.intersectSphere(new Sphere(new Vector3(), BALL_M), at)) continue;
      const cosine = -at.normalize().dot(caster.ray.direction);
      const [second = 0, most = 0] = caster.ray.direction
        .clone()
        .reflect(at)
        .toArray()
        .map(Math.abs)
        .sort((a, b) => a - b)
        .slice(1);
      // Mirrors blur the border of two faces, and three.js' a little more.
      if (room === 'cube' && second > 0.85 * most) continue;
      const light = (of: Uint8Array): number[] => pixel(of, x, y).slice(0, 3).map(linear);
      // At the rim, three.js blurs where normals turn quickly.
      if (cosine > 0.25) samples.push({ cosine, seen: light(seen), mirror: light(mirror) });
    }
  }
  return { samples, error: stand.gl.getError() };
}

/** How many textures, framebuffers and renderbuffers scenes with glass of several sizes have left. */
export function leftOver() {
  const { gl } = stand;
  const counts = { textures: 0, framebuffers: 0, renderbuffers: 0 };
  const count = (
    create: 'createTexture' | 'createFramebuffer' | 'createRenderbuffer',
    remove: 'deleteTexture' | 'deleteFramebuffer' | 'deleteRenderbuffer',
    kind: keyof typeof counts,
  ) => {
    const [made, freed] = [gl[create].bind(gl), gl[remove].bind(gl)];
    Object.assign(gl, {
      [create]: () => {
        counts[kind]++;
        return made();
      },
      [remove]: (thing: WebGLTexture & WebGLFramebuffer & WebGLRenderbuffer) => {
        counts[kind]--;
        freed(thing);
      },
    });
  };
  count('createTexture', 'deleteTexture', 'textures');
  count('createFramebuffer', 'deleteFramebuffer', 'framebuffers');
  count('createRenderbuffer', 'deleteRenderbuffer', 'renderbuffers');
  shoot([pane(), sheet(flat(0xffffff), 0, 0, 0, 1)]);
  shoot([pane({ roughness: 0.5 }), sheet(flat(0xffffff), 0, 0, 0, 1)]);
  return counts;
}
