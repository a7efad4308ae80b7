import {
  AdditiveBlending,
  AnimationMixer,
  BoxGeometry,
  Color,
  DirectionalLight,
  Group,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  type Object3D,
  type PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import type { DrawnScene } from '../../nodes/kit/runtime.ts';
import type { LightList, ObjectList } from '../../nodes/kit/scene-lists.ts';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import type { NumberView } from '../../nodes/kit/value-views.ts';
import { upset } from './runtime-kit.ts';
import {
  covered,
  createGl,
  createStand,
  difference,
  drawView,
  HEIGHT,
  type ItemOptions,
  item,
  lights,
  loadUrl,
  lookingAt,
  normalizing,
  objects,
  pixel,
  readPixels,
  type Stand,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const NO_SHADOWS = { shadowMaps: null, occlusion: null };
const FRONT = lookingAt([0, 0, 2], [0, 0, 0]);
const CENTER = [WIDTH / 2, HEIGHT / 2] as const;

/** Draws lists once, on a cleared layer. */
function shoot(
  stand: Stand,
  lists: readonly ObjectList[],
  options: { camera?: PerspectiveCamera; lights?: LightList[]; ambient?: NumberView } = {},
): Uint8Array {
  const { backend, layer } = stand;
  const scene = backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded', ambient: options.ambient ?? { value: 0 } });
  scene.update(lists, options.lights ?? []);
  layer.clear();
  scene.draw(drawView(viewOf(options.camera ?? FRONT), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

/** A sheet that fills the picture, `z` meters towards the camera. */
function sheet(material: Material, z = 0, options: ItemOptions = {}) {
  return item(new Mesh(new PlaneGeometry(9, 9), material), { ...options, at: translation(0, 0, z) });
}

export function blending() {
  const stand = createStand();
  const center = (...items: ReturnType<typeof item>[]): number[] => pixel(shoot(stand, [objects(...items)]), ...CENTER);
  const veil = new MeshBasicMaterial({ color: 0xffffff, transparent: true, opacity: 0.4 });
  const glow = new MeshBasicMaterial({ color: new Color(0.2159, 0, 0), blending: AdditiveBlending, transparent: true });
  const green = new MeshBasicMaterial({ color: 0x00ff00 });
  const glass = new MeshPhysicalMaterial({ transmission: 1, roughness: 0, ior: 1, specularIntensity: 0 });
  const result = {
    opaque: center(sheet(green)),
    veil: center(sheet(veil)),
    darkVeilOverVeil: center(sheet(veil), sheet(new MeshBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.4 }), 0.1)),
    veilOverOpaque: center(sheet(veil, 0.1), sheet(green)),
    glow: center(sheet(glow)),
    glowOverOpaque: center(sheet(glow, 0.1), sheet(green)),
    glass: center(sheet(glass)),
    glassOverOpaque: center(sheet(glass, 0.1), sheet(green)),
  };
  return { ...result, error: stand.gl.getError() };
}

/** A red wall, a phantom sheet before its left half, and a blue box before both. */
export function phantoms() {
  const stand = createStand();
  const wall = objects(sheet(new MeshBasicMaterial({ color: 0xff0000 }), -1));
  const ghost = new MeshBasicMaterial({ color: 0x00ff00, transparent: true, opacity: 0.2 });
  const half = item(new Mesh(new PlaneGeometry(4, 9), ghost), {
    role: 'phantom',
    at: translation(-2, 0, 0),
  });
  const box = item(new Mesh(new BoxGeometry(0.3, 0.3, 0.3), new MeshBasicMaterial({ color: 0x0000ff })), { at: translation(-0.3, 0, 0.5) });
  const one = shoot(stand, [wall, objects(half), objects(box)]);
  const other = shoot(stand, [objects(box, half), wall]);
  const at = (x: number): number[] => pixel(one, x, HEIGHT / 2);
  return { hidden: at(5), box: at(54), open: at(120), orderMatters: difference(one, other, 0).pixels, error: stand.gl.getError() };
}

/** As a three.js user would place it: in a hierarchy, on a canvas of its own. */
function plainImage(root: Object3D, at: Matrix4, camera: PerspectiveCamera): Uint8Array {
  const gl = createGl();
  const three = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  three.setClearColor(0, 0);
  const group = new Group();
  group.applyMatrix4(at);
  const light = new DirectionalLight(0xffffff, Math.PI);
  light.position.set(0.3, 1, 0.5);
  three.render(new Scene().add(group.add(root), light), camera);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  three.dispose();
  return pixels;
}

/** One animated model in two places, against three.js by itself, and against itself. */
export async function placements(url: string) {
  const stand = createStand();
  const model = await loadUrl(stand.backend, url);
  const pose = (timeS: number): Object3D => {
    const root = model.instantiate();
    const mixer = new AnimationMixer(root);
    const [clip] = model.clips;
    if (clip) mixer.clipAction(clip).play();
    mixer.setTime(timeS);
    root.traverse((object) => {
      const { morphTargetInfluences } = object as Mesh;
      morphTargetInfluences?.fill(0.6, 0, 1);
    });
    root.updateMatrixWorld(true);
    return root;
  };
  const root = pose(0.3);
  const unit = normalizing(root).premultiply(new Matrix4().makeScale(0.5, 0.5, 0.5));
  const left = new Matrix4().makeTranslation(-0.6, 0, 0).multiply(unit);
  const right = new Matrix4().makeTranslation(0.6, 0, 0).multiply(unit);
  const sunlight = [lights(sun([0.3, 1, 0.5]))];
  const draw = (camera: PerspectiveCamera, ...places: Matrix4[]): Uint8Array =>
    shoot(stand, [objects(...places.map((at) => item(root, { at })))], { camera, lights: sunlight });
  const leftAlone = draw(FRONT, left);
  const rightAlone = draw(FRONT, right);
  const both = draw(FRONT, left, right);
  const union = leftAlone.map((value, i) => Math.max(value, rightAlone[i] ?? 0));
  const result = {
    drawn: covered(leftAlone),
    plain: difference(leftAlone, plainImage(pose(0.3), left, FRONT)),
    // Seen from the same side, either place shows the same picture.
    samePose: difference(draw(lookingAt([-0.6, 0, 2], [-0.6, 0, 0]), left), draw(lookingAt([0.6, 0, 2], [0.6, 0, 0]), right), 3),
    undisturbed: difference(both, union, 0),
    order: difference(both, draw(FRONT, right, left), 0),
    moves: difference(leftAlone, shoot(stand, [objects(item(pose(0.6), { at: left }))], { lights: sunlight })).pixels,
  };
  model.dispose();
  return { ...result, error: stand.gl.getError() };
}

/** Two eyes side by side in one framebuffer, off-center, against each drawn alone. */
export function views() {
  const stand = createStand();
  const { backend, layer, gl } = stand;
  const list = objects(item(new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial({ color: 0xff8800 }))));
  const eye = (x: number, shift: number, viewport: ViewFrame['viewport']): ViewFrame => {
    const view = viewOf(lookingAt([x, 0.3, 1.5], [x, 0, 0], 80 / 120), viewport);
    view.clipFromView[8] = shift;
    return view;
  };
  const scene = backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded' });
  scene.update([list], [lights(sun([1, 1, 1]))]);
  const drawAll = (...eyes: ViewFrame[]): Uint8Array => {
    layer.clear();
    eyes.forEach((view, i) => {
      scene.draw(drawView(view, layer.framebuffer, i));
    });
    return layer.pixels();
  };
  const left = eye(-0.03, 0.1, { x: 0, y: 0, widthPx: 80, heightPx: 120 });
  const right = eye(0.03, -0.1, { x: 80, y: 0, widthPx: 80, heightPx: 120 });
  const both = drawAll(left, right);
  const union = drawAll(left).map((value, i) => Math.max(value, both[i] ?? 0));
  const rightAlone = drawAll(right);
  const half = (pixels: Uint8Array, from: number): Uint8Array =>
    pixels.filter((_, i) => (i >> 2) % WIDTH >= from && (i >> 2) % WIDTH < from + 80);
  const apart = difference(half(both, 0), half(both, 80), 8).pixels;
  return {
    left: difference(union, both, 0),
    right: difference(half(rightAlone, 80), half(both, 80), 0),
    outside: covered(half(rightAlone, 0)),
    apart,
    error: gl.getError(),
  };
}

/** A changed value is seen at once and compiles nothing; hidden parts and whole lists come and go. */
export function live() {
  const { backend, layer, gl } = createStand();
  const material = new MeshLambertMaterial({ color: 0xff0000 });
  const mesh = new Mesh(new PlaneGeometry(9, 9), material);
  const root = new Group().add(mesh);
  const list = objects(item(root));
  const scene = backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded', ambient: { value: 0 } });
  const draw = (): number[] => {
    scene.update([list], [lights(sun([0, 0, 1]))]);
    layer.clear();
    scene.draw(drawView(viewOf(FRONT), layer.framebuffer));
    return pixel(layer.pixels(), ...CENTER);
  };
  const first = draw();
  const compiled = backend.counts().programs;
  material.color.set(0x000000);
  material.emissive.setRGB(0, 0.2159, 0);
  const green = draw();
  const compiledAfter = backend.counts().programs;
  root.visible = false;
  const hidden = draw();
  root.visible = true;
  list.items[0]?.worldFromObject.makeTranslation(0, 0, 100);
  const behind = draw();
  list.items[0]?.worldFromObject.identity();
  material.transparent = true;
  material.opacity = 0.4;
  material.needsUpdate = true;
  const faded = draw();
  list.items.length = 0;
  list.version++;
  const gone = draw();
  return { first, green, hidden, behind, faded, gone, recompiled: compiledAfter - compiled, error: gl.getError() };
}

/** Whatever others did to the context, also between frames, and what is left to them. */
export function state() {
  const { gl, backend, layer } = createStand();
  const material = new MeshStandardMaterial({ color: 0x88ccff });
  const ball = item(new Mesh(new SphereGeometry(0.5), material));
  const phantom = item(new Mesh(new SphereGeometry(0.2), material), { role: 'phantom', at: translation(0.2, 0, 0.6) });
  const begin = () => backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded' });
  const draw = (scene: DrawnScene): Uint8Array => {
    layer.clear();
    scene.draw(drawView(viewOf(FRONT), layer.framebuffer));
    return layer.pixels();
  };
  // Something unlit first, so that the surroundings are made between two frames, in whatever state the context is then.
  const late = begin();
  const list = objects(item(new Mesh(new BoxGeometry(), new MeshBasicMaterial())));
  late.update([list], []);
  draw(late);
  list.items.splice(0, 1, ball, phantom);
  list.version++;
  upset(gl);
  late.update([list], [lights(sun([0, 0, 1]))]);
  const lateSurroundings = draw(late);
  const scene = begin();
  scene.update([list], [lights(sun([0, 0, 1]))]);
  const before = draw(scene);
  layer.clear();
  upset(gl);
  scene.draw(drawView(viewOf(FRONT), layer.framebuffer));
  const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) === layer.framebuffer;
  const scissor = gl.isEnabled(gl.SCISSOR_TEST);
  const after = layer.pixels();
  const other = createStand();
  const elsewhere = other.backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded' });
  elsewhere.update([list], [lights(sun([0, 0, 1]))]);
  other.layer.clear();
  elsewhere.draw(drawView(viewOf(FRONT), other.layer.framebuffer));
  return {
    upset: difference(before, after, 0),
    late: difference(lateSurroundings, other.layer.pixels(), 0),
    drawn: covered(before),
    bound,
    scissor,
    error: gl.getError(),
  };
}

/** Straight into the canvas, as a page without layers does. */
export function canvas() {
  const { gl, backend } = createStand();
  const scene = backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded' });
  scene.update([objects(sheet(new MeshBasicMaterial({ color: new Color(0.2159, 0, 0) })))], []);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  scene.draw(drawView(viewOf(FRONT, { x: 0, y: 0, widthPx: 80, heightPx: 120 }), null));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = readPixels(gl, WIDTH, HEIGHT);
  return { left: pixel(pixels, 40, 60), right: pixel(pixels, 120, 60), error: gl.getError() };
}

/** Brightness of a white matt ball and a metal one in the neutral surroundings, in linear light, from six sides. */
export function surroundings() {
  const stand = createStand(48, 48);
  const ball = (material: Material): ObjectList => objects(item(new Mesh(new SphereGeometry(1, 48, 32), material)));
  const matt = ball(new MeshStandardMaterial({ color: 0xffffff, roughness: 1 }));
  const metal = ball(new MeshStandardMaterial({ color: 0xffffff, roughness: 0.2, metalness: 1 }));
  const from = (list: ObjectList, eye: [number, number, number]): number[] => {
    const camera = lookingAt(eye, [0, 0, 0.001], 1);
    const { backend, layer } = stand;
    const scene = backend.serviceFor(NO_SHADOWS).createScene({ kind: 'shaded', ambient: { value: 0.5 } });
    scene.update([list], []);
    layer.clear();
    scene.draw(drawView(viewOf(camera, { x: 0, y: 0, widthPx: 48, heightPx: 48 }), layer.framebuffer));
    const pixels = layer.pixels();
    scene.dispose();
    const values: number[] = [];
    for (let i = 0; i < pixels.length; i += 4)
      if (pixels[i + 3] === 255) values.push(new Color().setRGB((pixels[i] ?? 0) / 255, 0, 0, 'srgb').r);
    return values;
  };
  const mean = (values: number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  const eyes: [number, number, number][] = [
    [20, 0, 0],
    [-20, 0, 0],
    [0, 20, 0],
    [0, -20, 0],
    [0, 0, 20],
    [0, 0, -20],
  ];
  const means = eyes.map((eye) => mean(from(matt, eye)));
  return {
    mean: mean(means),
    fromAbove: means[2],
    fromBelow: means[3],
    darkestMetal: Math.min(...eyes.flatMap((eye) => Math.min(...from(metal, eye)))),
    brightestMetal: Math.max(...eyes.flatMap((eye) => Math.max(...from(metal, eye)))),
    error: stand.gl.getError(),
  };
}
