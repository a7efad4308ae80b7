import {
  type BufferGeometry,
  DataTexture,
  DirectionalLight,
  type Material,
  Matrix3,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  RepeatWrapping,
  Scene,
  type WebGLProgramParametersWithUniforms,
  WebGLRenderer,
} from 'three';
import { createOcclusionPatch } from '../../../export/runtime/scenes/materials/occlusion-patch.ts';
import { patchMaterial } from '../../../export/runtime/scenes/materials/shader-patch.ts';
import type { RoomDepth } from '../../../nodes/kit/session.ts';
import { type Drawn, measureFrames } from './frame-ms.ts';

/** A color alone, or light of four lamps on a coat of lacquer, with textures. */
export type Surface = 'simple' | 'heavy';

/** Where a shader discards what the room hides: `last` is how scenes are drawn. */
export const PLACES = ['last', 'before light', 'first'] as const;
export type Place = (typeof PLACES)[number];

const SIZE = { widthPx: 640, heightPx: 480 };
const FOV_DEG = 60;
const OBJECT_M = 2;
const LIGHTS: readonly (readonly [x: number, y: number, z: number])[] = [
  [1, 1, 1],
  [-1, 1, 1],
  [1, -1, 1],
  [-1, -1, 1],
];
const TEST = /float scrimVisible = [^;]*;\s*if \( scrimVisible <= 0\.0 \) discard;/;
const STARTS: Readonly<Record<Exclude<Place, 'last'>, string>> = {
  'before light': '#include <lights_fragment_begin>',
  first: 'void main() {',
};

/**
 * Milliseconds per frame of an object that covers the view, for each place of the test.
 *
 * @param hidden Part of the view that the room hides, from 0 to 1.
 */
export function measure(surface: Surface, hidden: number, frames: number): Record<Place, number> {
  const { scenes } = open(surface, hidden);
  return Object.fromEntries(PLACES.map((place) => [place, measureFrames(scenes[place], frames)])) as Record<Place, number>;
}

interface Opened {
  readonly key: string;
  readonly scenes: Readonly<Record<Place, Drawn>>;
}

let opened: Opened | undefined;
let renderer: WebGLRenderer | undefined;

function open(surface: Surface, hidden: number): Opened {
  const key = `${surface} ${hidden}`;
  if (opened?.key === key) return opened;
  renderer ??= createRenderer();
  const { widthPx, heightPx } = SIZE;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const camera = new PerspectiveCamera(FOV_DEG, widthPx / heightPx, 0.05, 100);
  const roomDepth = { views: [roomOf(gl, hidden)] };
  const geometry = new PlaneGeometry(8, 8);
  const scenes = PLACES.map((place): [Place, Drawn] => {
    const patch = createOcclusionPatch({ roomDepth, params: {} });
    const material = materialOf(surface);
    const apply = (shader: WebGLProgramParametersWithUniforms) => {
      patch.apply(shader);
      shader.fragmentShader = moved(shader.fragmentShader, place);
    };
    patchMaterial(material, null, [{ key: place, apply }]);
    const scene = sceneOf(geometry, material);
    const draw = () => {
      patch.bind({
        view: undefined as never,
        viewIndex: 0,
        framebuffer: null,
        viewport: { x: 0, y: 0, widthPx, heightPx },
      });
      renderer?.render(scene, camera);
    };
    return [place, { gl, draw }];
  });
  opened = { key, scenes: Object.fromEntries(scenes) as Record<Place, Drawn> };
  return opened;
}

function createRenderer(): WebGLRenderer {
  const made = new WebGLRenderer({ antialias: false });
  made.setSize(SIZE.widthPx, SIZE.heightPx, false);
  return made;
}

/** A shader whose test stands where `place` says; one without light has no other place than the first. */
function moved(source: string, place: Place): string {
  const [test] = TEST.exec(source) ?? [];
  if (test === undefined) throw new Error('The shader does not test the room.');
  if (place === 'last') return source;
  const start = source.includes(STARTS[place]) ? STARTS[place] : STARTS.first;
  const rest = source.replace(test, '');
  return start === STARTS.first ? rest.replace(start, `${start}\n${test}`) : rest.replace(start, `${test}\n${start}`);
}

function materialOf(surface: Surface): Material {
  if (surface === 'simple') return new MeshBasicMaterial({ color: 0x808080 });
  const bumps = noise();
  return new MeshPhysicalMaterial({ map: bumps, normalMap: bumps, roughnessMap: bumps, roughness: 0.6, metalness: 0.2, clearcoat: 1 });
}

function sceneOf(geometry: BufferGeometry, material: Material): Scene {
  const scene = new Scene();
  const plane = new Mesh(geometry, material);
  plane.position.z = -OBJECT_M;
  scene.add(plane);
  for (const place of LIGHTS) {
    const light = new DirectionalLight(0xffffff, 1);
    light.position.set(...place);
    scene.add(light);
  }
  return scene;
}

function noise(): DataTexture {
  const sizePx = 256;
  const data = Uint8Array.from({ length: sizePx * sizePx * 4 }, (_, i) => (i % 4 === 2 ? 255 : 118 + ((i * 7919) % 20)));
  const texture = new DataTexture(data, sizePx, sizePx);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.repeat.set(4, 4);
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** Room depth with a near wall at the left. */
function roomOf(gl: WebGL2RenderingContext, hidden: number): RoomDepth {
  const [widthPx, heightPx] = [160, 120];
  const data = Float32Array.from({ length: widthPx * heightPx }, (_, i) =>
    (i % widthPx) / widthPx < hidden ? OBJECT_M / 2 : OBJECT_M * 2,
  );
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, widthPx, heightPx, 0, gl.RED, gl.FLOAT, data);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  gl.bindTexture(gl.TEXTURE_2D, null);
  renderer?.resetState();
  return {
    texture,
    widthPx,
    heightPx,
    interpolate: true,
    uvFromViewUv: Float32Array.from(new Matrix3().elements),
    worldFromDepth: Float32Array.from(new Matrix4().elements),
  };
}
