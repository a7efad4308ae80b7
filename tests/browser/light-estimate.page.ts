import {
  type Material,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Raycaster,
  Sphere,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createPassDrawer } from '../../export/runtime/gl/pass-drawer.ts';
import { createProgramCache } from '../../export/runtime/gl/program-cache.ts';
import { createCameraMean } from '../../export/runtime/light/camera-mean.ts';
import type { LightItem, ObjectItem, ProbeLightItem } from '../../nodes/kit/scene-lists.ts';
import type { LightEstimate, ReflectionCube, SessionFrame } from '../../nodes/kit/session.ts';
import { definition } from '../../nodes/world/light-estimate/definition.ts';
import { create } from '../../nodes/world/light-estimate/runtime.ts';
import { fakeContext } from '../support/node-context.ts';
import {
  createGl,
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  type Stand,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

type Triple = readonly [number, number, number];

let made: Stand | null = null;
function sharedStand(): Stand {
  made ??= createStand();
  return made;
}

/** Nine coefficients with colors of their own, bright from above and from the right, nowhere below zero. */
export const HARMONICS = Float32Array.of(
  ...[1.1, 0.9, 0.8],
  ...[0.3, 0.25, 0.4],
  ...[-0.1, 0.12, 0.05],
  ...[0.2, -0.1, 0.02],
  ...[0.05, 0.1, -0.08],
  ...[0.12, -0.06, 0.04],
  ...[-0.1, 0.08, 0.12],
  ...[0.07, 0.05, -0.05],
  ...[0.06, -0.09, 0.1],
);

function probe(more: Partial<ProbeLightItem> = {}): ProbeLightItem {
  return { key: 'around', kind: 'probe', sphericalHarmonics: HARMONICS, reflection: null, intensity: 1, ...more };
}

function shoot(stand: Stand, things: readonly ObjectItem[], lamps: readonly LightItem[], camera = lookingAt([0.9, 0.8, 1.4], [0, 0, 0])) {
  const { backend, layer } = stand;
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 1 } });
  scene.update([objects(...things)], [lights(...lamps)]);
  layer.clear();
  scene.draw(drawView(viewOf(camera), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

/** Irradiance by the matrix of Ramamoorthi and Hanrahan 2001, eq. 11 to 13, with their printed constants. */
function irradiance(channel: number, { x, y, z }: Vector3): number {
  const [c1, c2, c3, c4, c5] = [0.429043, 0.511664, 0.743125, 0.886227, 0.247708];
  const l = (i: number): number => HARMONICS[i * 3 + channel] ?? 0;
  return (
    c1 * l(8) * (x * x - y * y) +
    c3 * l(6) * z * z +
    c4 * l(0) -
    c5 * l(6) +
    2 * c1 * (l(4) * x * y + l(7) * x * z + l(5) * y * z) +
    2 * c2 * (l(3) * x + l(1) * y + l(2) * z)
  );
}

const encode = (linear: number): number => 255 * (linear <= 0.0031308 ? linear * 12.92 : 1.055 * linear ** (1 / 2.4) - 0.055);

/** A white matt ball, pixel by pixel, against what its light comes to by hand. */
export function lambert(intensity: number) {
  const stand = sharedStand();
  const camera = lookingAt([0.9, 0.8, 1.4], [0, 0, 0]);
  const ball = item(new Mesh(new SphereGeometry(0.6, 192, 128), new MeshLambertMaterial()));
  const pixels = shoot(stand, [ball], [probe({ intensity })], camera);
  const caster = new Raycaster();
  const sphere = new Sphere(new Vector3(), 0.6);
  const normal = new Vector3();
  let [count, worst, least, most] = [0, 0, 255, 0];
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      caster.setFromCamera(new Vector2(((x + 0.5) / WIDTH) * 2 - 1, ((y + 0.5) / HEIGHT) * 2 - 1), camera);
      // Not the last pixels at its edge, which are partly beside it.
      if (caster.ray.distanceToPoint(sphere.center) > 0.58 || !caster.ray.intersectSphere(sphere, normal)) continue;
      normal.normalize();
      const seen = pixel(pixels, x, y);
      for (let c = 0; c < 3; c++) {
        const wanted = encode(Math.min(1, Math.max(0, (irradiance(c, normal) * intensity) / Math.PI)));
        worst = Math.max(worst, Math.abs((seen[c] ?? 0) - wanted));
        least = Math.min(least, wanted);
        most = Math.max(most, wanted);
      }
      count++;
    }
  }
  return { count, worst, range: most - least, error: stand.gl.getError() };
}

const SIDES: readonly Triple[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];
/** sRGB bytes of the faces +x, −x, +y, −y, +z, −z. */
const COLORS: readonly Triple[] = [
  [200, 40, 40],
  [40, 200, 40],
  [40, 40, 200],
  [200, 200, 40],
  [40, 200, 200],
  [200, 40, 200],
];

export function cube(gl: WebGL2RenderingContext, version: number, turn = 0): ReflectionCube {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  COLORS.forEach((_, i) => {
    const color = COLORS[(i + turn) % 6] ?? [0, 0, 0];
    const data = new Uint8Array(Array.from({ length: 16 * 16 }, () => [...color, 255]).flat());
    gl.texImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, gl.SRGB8_ALPHA8, 16, 16, 0, gl.RGBA, gl.UNSIGNED_BYTE, data);
  });
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  return { texture, version };
}

/** What mirrors that face the six sides show of a cube map, and of another that takes its place. */
export function mirrors() {
  const stand = sharedStand();
  const { gl, backend, layer } = stand;
  // What three keeps for such materials is there before.
  shoot(stand, [item(new Mesh(new PlaneGeometry(), new MeshStandardMaterial()))], [probe()]);
  const before = backend.counts().textures;
  const light = probe();
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 1 } });
  const look = (towards: Triple): number[] => {
    const plane = new Mesh(new PlaneGeometry(), new MeshStandardMaterial({ color: 0xffffff, metalness: 1, roughness: 0 }));
    plane.lookAt(...towards);
    const [x, y, z] = towards;
    scene.update([objects(item(plane))], [lights(light)]);
    layer.clear();
    scene.draw(drawView(viewOf(lookingAt([x, y, z || 1e-4], [0, 0, 0])), layer.framebuffer));
    return pixel(layer.pixels(), WIDTH / 2, HEIGHT / 2).slice(0, 3);
  };
  light.reflection = cube(gl, 1);
  const first = SIDES.map(look);
  light.reflection = cube(gl, 2, 1);
  const second = SIDES.map(look);
  // A quarter turn about y, after which what lies towards -z is seen towards +x.
  light.reflection = { ...cube(gl, 3), cubeFromWorld: Float32Array.of(0, 0, -1, 0, 1, 0, 1, 0, 0) };
  const turned = SIDES.map(look);
  light.reflection = null;
  const without = look([0, 1, 0]);
  scene.dispose();
  return { first, second, turned, without, colors: COLORS, leaked: backend.counts().textures - before, error: gl.getError() };
}

/** What it takes to draw a frame after a change of the light: draws that are made, buffers that are made, and what a matt and a shiny plane show. */
export function redrawn() {
  const stand = sharedStand();
  const { gl, backend, layer } = stand;
  const sphericalHarmonics = HARMONICS.slice();
  const light = probe({ sphericalHarmonics, reflection: cube(gl, 7) });
  const plane = (material: Material, x: number): ObjectItem =>
    item(new Mesh(new PlaneGeometry(1, 2).rotateX(-Math.PI / 2), material), { at: translation(x, 0, 0) });
  const things = objects(plane(new MeshLambertMaterial(), -0.5), plane(new MeshStandardMaterial({ metalness: 1, roughness: 0 }), 0.5));
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 1 } });
  const tally = { draws: 0, buffers: 0 };
  const { drawElements, createBuffer } = gl;
  gl.drawElements = (...args) => {
    tally.draws++;
    drawElements.apply(gl, args);
  };
  gl.createBuffer = () => {
    tally.buffers++;
    return createBuffer.call(gl);
  };
  const look = () => {
    Object.assign(tally, { draws: 0, buffers: 0 });
    scene.update([things], [lights(light)]);
    layer.clear();
    scene.draw(drawView(viewOf(lookingAt([0, 2, 1e-4], [0, 0, 0])), layer.framebuffer));
    const pixels = layer.pixels();
    const at = (x: number): number[] => pixel(pixels, WIDTH / 2 + x, HEIGHT / 2).slice(0, 3);
    return { ...tally, matt: at(-8), shiny: at(8) };
  };
  look();
  const still = look();
  for (let i = 0; i < 27; i++) sphericalHarmonics[i] = (HARMONICS[i] ?? 0) * 0.5;
  const dimmed = look();
  light.reflection = cube(gl, 8, 1);
  const mirroredAnew = look();
  light.reflection = null;
  const without = look();
  for (let i = 0; i < 27; i++) sphericalHarmonics[i] = HARMONICS[i] ?? 0;
  const brightened = look();
  scene.dispose();
  Object.assign(gl, { drawElements: drawElements.bind(gl), createBuffer: createBuffer.bind(gl) });
  return { still, dimmed, mirroredAnew, without, brightened, error: gl.getError() };
}

/** On which side of a ball's foot its shadow lies on the floor, for lights from several sides: the way from foot to shadow. */
export function shadowSides(towards: readonly Triple[]) {
  const stand = sharedStand();
  const { backend, layer } = stand;
  const camera = lookingAt([0, 4, 1e-3], [0, 0, 0]);
  const ball = item(new Mesh(new SphereGeometry(0.2, 32, 24), new MeshLambertMaterial()), { at: translation(0, 0.5, 0) });
  const floor = item(new Mesh(new PlaneGeometry(6, 6).rotateX(-Math.PI / 2)), { role: 'phantom', castsShadow: false });
  return towards.map((direction) => {
    const light: LightEstimate = {
      sphericalHarmonics: HARMONICS,
      primaryDirectionWorld: Float32Array.from(new Vector3(...direction).normalize()),
      primaryIntensity: Float32Array.of(1, 1, 1),
    };
    const { ctx } = fakeContext(definition, { services: { session: { light, cameraMean: null } as never } });
    create(ctx).update({} as never);
    const casters = objects(ball);
    const maps = backend.createShadowMaps([casters], [ctx.outputs.lights]);
    const look = { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) } } as const;
    const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null }).createScene(look);
    scene.update([objects(floor)], [ctx.outputs.lights]);
    maps.update();
    layer.clear();
    scene.draw(drawView(viewOf(camera), layer.framebuffer));
    const pixels = layer.pixels();
    scene.dispose();
    maps.dispose();
    let [sumX, sumY, sum] = [0, 0, 0];
    for (let i = 0; i < WIDTH * HEIGHT; i++) {
      const alpha = pixels[i * 4 + 3] ?? 0;
      sumX += alpha * ((i % WIDTH) + 0.5);
      sumY += alpha * (Math.floor(i / WIDTH) + 0.5);
      sum += alpha;
    }
    // Seen from above, up in the picture is away from the camera's feet: -z. 4 m away, 50° are 2 · 4 · tan 25° high.
    const metersPerPx = (8 * Math.tan((25 * Math.PI) / 180)) / HEIGHT;
    return { x: (sumX / sum - WIDTH / 2) * metersPerPx, z: -(sumY / sum - HEIGHT / 2) * metersPerPx };
  });
}

/** The mean of a picture that is half one gray and half another, cut to one of them, and none. */
export async function cameraMeans(held: boolean) {
  const gl = createGl();
  const objectsOfGl = createGlObjects(gl);
  const programs = createProgramCache(objectsOfGl);
  const drawer = createPassDrawer(objectsOfGl);
  const tool: Parameters<typeof createCameraMean>[0]['tool'] = (shader) => {
    const program = programs.acquire(shader);
    programs.finish(program);
    return program;
  };
  const mean = createCameraMean({ objects: objectsOfGl, drawer, tool }, held);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  const bytes = Uint8Array.from({ length: 64 * 4 }, (_, i) => [i < 128 ? 255 : 0, 128, 0, 255][i % 4] ?? 0);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 64, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  let index = 0;
  const read = async (uvFromViewUv: number[] | null, isNew: (seen: Readonly<Float32Array> | null) => boolean): Promise<number[] | null> => {
    const cameraImage = uvFromViewUv && { texture, widthPx: 64, heightPx: 1, uvFromViewUv: Float32Array.from(uvFromViewUv) };
    let seen: Readonly<Float32Array> | null = null;
    // A running page reads what was drawn some frames ago, without waiting.
    for (;;) {
      seen = mean.read({ index: index++, timeS: index, viewCount: 1, views: [{ cameraImage }] } as unknown as SessionFrame);
      if (held || isNew(seen)) break;
      await new Promise(requestAnimationFrame);
    }
    return seen && [...seen];
  };
  const whole = await read([1, 0, 0, 0, 1, 0, 0, 0, 1], (seen) => seen !== null);
  const left = await read([0.2, 0, 0, 0, 1, 0, 0, 0, 1], (seen) => seen !== null && seen[0] !== whole?.[0]);
  const none = await read(null, (seen) => seen === null);
  const error = gl.getError();
  mean.dispose();
  drawer.dispose();
  const { textures, framebuffers } = objectsOfGl.counts();
  return { whole, left, none, left_over: textures + framebuffers, error };
}
