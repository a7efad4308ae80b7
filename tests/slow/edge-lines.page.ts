import {
  AnimationMixer,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  FloatType,
  type Material,
  Mesh,
  MeshLambertMaterial,
  MeshNormalMaterial,
  NearestFilter,
  type Object3D,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  TorusKnotGeometry,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { createStand, drawView, lights, lookingAt, normalizing, objects, sun, viewOf } from '../browser/scenes-kit.ts';
import { drawnWith, technique, type Values } from '../browser/techniques-kit.ts';

/** Lines of techniques against silhouettes that three.js' own depth and normals show in the same view. */

const WIDTH = 480;
const HEIGHT = 360;
const { backend, layer, gl } = createStand(WIDTH, HEIGHT);

const PAPER: Values = { inkColor: [0, 0, 0, 1], washColor: [1, 1, 1, 1], ownColor: 0, shade: 0, rate: 0, suggestive: 0, grain: 0 };

export interface Lines {
  /** Pixels of the silhouette, and those with a pixel of a line within 2 pixels. */
  readonly silhouette: number;
  readonly found: number;
  /** Pixels of lines within the object that are far from any edge of depth or normals. */
  readonly stray: number;
  /** Pixels of lines. */
  readonly ink: number;
  readonly error: number;
  readonly pixels: readonly number[];
}

/** A model in the middle of its first clip. */
async function load(url: string): Promise<Object3D> {
  const { scene, animations } = await new GLTFLoader().loadAsync(url);
  const [clip] = animations;
  if (clip) {
    const mixer = new AnimationMixer(scene);
    mixer.clipAction(clip).play();
    mixer.setTime(0.3);
  }
  scene.updateMatrixWorld(true);
  return scene;
}

const models = new Map<string, Object3D>();

export interface Place {
  readonly eye: readonly [number, number, number];
  readonly target: readonly [number, number, number];
}

/** Lines of a model in the unit sphere, at the origin. */
export async function linesOf(url: string, place: Place, values: Values): Promise<Lines> {
  const root = models.get(url) ?? (await load(url));
  models.set(url, root);
  return measure(root, place, values);
}

/** The same of a model whose faces are divided until they are too many for lines of their edges. */
export async function linesOfDivided(url: string, place: Place, values: Values): Promise<Lines> {
  const root = await load(url);
  root.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { position } = object.geometry.toNonIndexed().attributes;
    object.geometry = divided(divided(new BufferGeometry().setAttribute('position', position)));
    object.geometry.computeVertexNormals();
  });
  return measure(root, place, values);
}

/** Each triangle as four. */
function divided({ attributes: { position } }: BufferGeometry): BufferGeometry {
  const corners = position?.array ?? [];
  const divisions: number[] = [];
  for (let t = 0; t < corners.length; t += 9) {
    const [a, b, c] = [0, 3, 6].map((at) => [corners[t + at], corners[t + at + 1], corners[t + at + 2]] as number[]) as [
      number[],
      number[],
      number[],
    ];
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    for (const corner of [a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]) divisions.push(...corner);
  }
  return new BufferGeometry().setAttribute('position', new BufferAttribute(Float32Array.from(divisions), 3));
}

function middle(a: readonly number[], b: readonly number[]): number[] {
  return a.map((coordinate, axis) => (coordinate + (b[axis] ?? 0)) / 2);
}

const SHAPES = {
  box: () => new BoxGeometry(1, 0.7, 0.5),
  sheet: () => new PlaneGeometry(1, 0.7, 4, 4),
  /** 300,000 triangles. */
  knot: () => new TorusKnotGeometry(1, 0.3, 1000, 150),
};

export function linesOfShape(kind: keyof typeof SHAPES, place: Place, values: Values): Lines {
  return measure(new Mesh(SHAPES[kind](), new MeshLambertMaterial()), place, values);
}

/** Geometries and textures that a box with lines leaves behind after its geometry is disposed. */
export function leftBehind(place: Place): number {
  const geometries = [new BoxGeometry(1, 0.7, 0.5), new BoxGeometry(1, 0.7, 0.5)];
  // The first leaves what scenes share.
  const counts = geometries.map((geometry) => {
    measure(new Mesh(geometry, new MeshLambertMaterial()), place, {});
    for (const scene of scenes.splice(0)) scene.dispose();
    geometry.dispose();
    const { geometries: held, textures } = backend.counts();
    return held + textures;
  });
  return (counts[1] ?? 0) - (counts[0] ?? 0);
}

/** Lines of a flat sheet of 1 × 0.7 m, seen from the front at a distance; its border is drawn by strokes of their full width. */
export function linesOfSheet(distanceM: number, values: Values): Lines {
  return linesOfShape(
    'sheet',
    { eye: [0, 0, distanceM], target: [0, 0, 0] },
    { loosePx: 0, overshootPx: 0, taper: 0, depthWeight: 0, lightWeight: 0, strokePx: 8, waveM: 1, ...values },
  );
}

/** Scenes that were drawn. While they are there, three.js does not compile the shaders of the next ones again. */
const scenes: { dispose(): void }[] = [];

function measure(root: Object3D, { eye, target }: Place, values: Values): Lines {
  const at = normalizing(root);
  const camera = lookingAt(eye, target, WIDTH / HEIGHT);
  const seen = viewOf(camera, { x: 0, y: 0, widthPx: WIDTH, heightPx: HEIGHT });
  const list = objects(drawnWith(root, technique('loose-lines', { ...PAPER, ...values }), at));
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0.3 } });
  scene.update([list], [lights(sun([0.5, 0.7, 1]))]);
  layer.clear();
  scene.draw(drawView(seen, layer.framebuffer));
  const pixels = layer.pixels();
  const error = gl.getError();
  scenes.push(scene);

  // The reference draws the same object, placed by its own matrix.
  const holder = new Scene();
  root.updateMatrixWorld(true);
  holder.matrix.copy(at);
  holder.matrixAutoUpdate = false;
  holder.add(root);
  holder.updateMatrixWorld(true);
  const depth = reference(holder, camera, depthMaterial);
  const normals = reference(holder, camera, normalMaterial);
  root.removeFromParent();
  root.updateMatrixWorld(true);

  const size = WIDTH * HEIGHT;
  const isSilhouette = new Uint8Array(size);
  const isEdge = new Uint8Array(size);
  const isInk = new Uint8Array(size);
  for (let y = 1; y < HEIGHT - 1; y++) {
    for (let x = 1; x < WIDTH - 1; x++) {
      const i = y * WIDTH + x;
      isInk[i] = (pixels[i * 4 + 3] ?? 0) > 100 && (pixels[i * 4] ?? 0) < 110 ? 1 : 0;
      const here = depth[i * 4] ?? 0;
      if (here === 0) continue;
      for (const step of [-1, 1, -WIDTH, WIDTH]) {
        const there = depth[(i + step) * 4] ?? 0;
        // The object has a radius of 1.
        if (there === 0 || there - here > 0.08) isSilhouette[i] = 1;
        let turn = 0;
        for (let c = 0; c < 3; c++) turn += ((normals[i * 4 + c] ?? 0) - 0.5) * ((normals[(i + step) * 4 + c] ?? 0) - 0.5) * 4;
        if (there === 0 || Math.abs(there - here) > 0.02 || turn < Math.cos(0.4)) isEdge[i] = 1;
      }
    }
  }
  let silhouette = 0;
  let found = 0;
  let stray = 0;
  let ink = 0;
  for (let i = 0; i < size; i++) {
    if (isSilhouette[i]) {
      silhouette++;
      if (near(isInk, i, 2)) found++;
    }
    if (!isInk[i]) continue;
    ink++;
    if ((depth[i * 4] ?? 0) > 0 && !near(isEdge, i, 4 + Number(values.loosePx ?? 5))) stray++;
  }
  return { silhouette, found, stray, ink, error, pixels: [...pixels] };
}

function near(marks: Uint8Array, at: number, radius: number): boolean {
  const x0 = at % WIDTH;
  const y0 = Math.floor(at / WIDTH);
  for (let y = Math.max(0, y0 - radius); y <= Math.min(HEIGHT - 1, y0 + radius); y++)
    for (let x = Math.max(0, x0 - radius); x <= Math.min(WIDTH - 1, x0 + radius); x++)
      if (marks[y * WIDTH + x] && (x - x0) ** 2 + (y - y0) ** 2 <= radius ** 2) return true;
  return false;
}

const depthMaterial = new ShaderMaterial({
  vertexShader: `#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
varying float vDepth;
void main() {
  #include <skinbase_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  vDepth = -mvPosition.z;
}`,
  fragmentShader: 'varying float vDepth; void main() { gl_FragColor = vec4(vDepth, 0.0, 0.0, 1.0); }',
});
const normalMaterial = new MeshNormalMaterial({ flatShading: true });
let renderer: WebGLRenderer | null = null;

/** What a material shows of the scene in every pixel, bottom row first; 0 where there is nothing. */
function reference(scene: Scene, camera: ReturnType<typeof lookingAt>, material: Material): Float32Array {
  renderer ??= new WebGLRenderer();
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter });
  renderer.setRenderTarget(target);
  renderer.setClearColor(new Color(0, 0, 0), 0);
  renderer.clear();
  scene.overrideMaterial = material;
  renderer.render(scene, camera);
  const values = new Float32Array(WIDTH * HEIGHT * 4);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, values);
  target.dispose();
  return values;
}
