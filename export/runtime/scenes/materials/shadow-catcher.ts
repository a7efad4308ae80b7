import {
  CustomBlending,
  LessDepth,
  type Material,
  type Matrix4,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  type Texture,
  Vector3,
  Vector4,
} from 'three';
import type { DrawView, LightList, NumberView, ObjectItem, ObjectList, VectorView } from '../../../../nodes/kit/runtime.ts';
import { isLamp } from '../lights/is-lamp.ts';
import type { ShadowMap } from '../lights/light-map.ts';
import type { RenderedShadowMaps } from '../lights/shadow-maps.ts';
import { type Drawable, materialsOf } from '../proxies/drawable.ts';
import { createLampUniforms, setLamp, setLampCount } from './lamp-uniforms.ts';
import { isOpaque } from './layer-blending.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { CATCHER_VERTEX, type CatcherLights, catcherFragment } from './shadow-catcher-shader.ts';
import type { Twin } from './twins.ts';

/** The materials of one shadow layer: they share lights, strength and colour, and differ in what three compiles per object. */
export interface ShadowCatcher {
  createTwin(master: Material): Twin;
  /** Takes over strength and colour, changed lists, and this frame's matrices and lights. */
  update(receivers: readonly ObjectList[], lights: readonly LightList[]): void;
  /** Before a view is drawn; leaves no framebuffer bound. */
  beforeDraw(view: DrawView): void;
  dispose(): void;
}

export interface MapCatcherOptions {
  readonly strength: NumberView;
  readonly color: VectorView;
  readonly maps: RenderedShadowMaps | null;
  readonly occlusion: ShaderPatch | null;
}

/** Catches shadows by shadow maps: their edges are a little soft, and follow what pictures cut out. */
export function createMapCatcher({ strength, color, maps, occlusion }: MapCatcherOptions): ShadowCatcher {
  let lightLists: readonly LightList[] = [];
  const lamps = createLampUniforms();
  const flatMaps: (Texture | null)[] = [];
  const mapFromWorld: Matrix4[] = [];
  const flatBias: Vector3[] = [];
  const cubeMaps: (Texture | null)[] = [];
  const cubeReach: Vector4[] = [];
  const uniforms = {
    strength: { value: 0 },
    shadowColor: { value: new Vector4() },
    ...lamps,
    flatMaps: { value: flatMaps },
    mapFromWorld: { value: mapFromWorld },
    flatBias: { value: flatBias },
    cubeMaps: { value: cubeMaps },
    cubeReach: { value: cubeReach },
  };
  let compiled: CatcherLights = { flat: 0, cube: 0, plain: 0 };
  let fragmentShader = catcherFragment(compiled);
  const materials: ShaderMaterial[] = [];
  const counts = { flat: 0, cube: 0, plain: 0 };

  function addFlat(map: ShadowMap): void {
    const i = counts.flat++;
    flatMaps[i] = map.target.depthTexture;
    mapFromWorld[i] = map.mapFromWorld;
    flatBias[i] ??= new Vector3();
    flatBias[i].set(1 / map.target.width, map.bias, map.normalBias);
  }

  function addCube(map: ShadowMap): void {
    const i = counts.cube++;
    cubeMaps[i] = map.target.depthTexture;
    cubeReach[i] ??= new Vector4();
    cubeReach[i].set(map.nearM, map.farM, 2 / map.target.width, map.normalBias);
  }

  /** In three rounds, because the shader takes lights by the kind of their map. */
  function addLights(wanted: ShadowMap['kind'] | null): void {
    for (const list of lightLists) {
      for (const light of list.items) {
        if (!isLamp(light)) continue;
        const map = maps?.mapOf(light) ?? null;
        if ((map?.kind ?? null) !== wanted) continue;
        setLamp(lamps, counts.flat + counts.cube + counts.plain, light);
        if (map === null) counts.plain++;
        else if (map.kind === 'flat') addFlat(map);
        else addCube(map);
      }
    }
  }

  /** The shader is written for its lights; their number changes when one comes, goes, or begins to cast a shadow. */
  function fitShader(): void {
    const { flat, cube, plain } = counts;
    if (flat === compiled.flat && cube === compiled.cube && plain === compiled.plain) return;
    compiled = { flat, cube, plain };
    for (const array of [flatMaps, mapFromWorld, flatBias]) array.length = flat;
    for (const array of [cubeMaps, cubeReach]) array.length = cube;
    setLampCount(lamps, flat + cube + plain);
    fragmentShader = catcherFragment(compiled);
    for (const material of materials) {
      material.fragmentShader = fragmentShader;
      material.needsUpdate = true;
    }
  }

  return {
    createTwin: (master) => {
      const material = createCatcherMaterial(fragmentShader, uniforms, occlusion);
      materials.push(material);
      const sync = (): void => followSides(material, master);
      sync();
      return {
        material,
        sync,
        dispose: () => {
          materials.splice(materials.indexOf(material), 1);
          material.dispose();
        },
      };
    },
    update: (_receivers, lights) => {
      lightLists = lights;
      uniforms.strength.value = strength.value;
      uniforms.shadowColor.value.fromArray(color.value);
    },
    beforeDraw: () => {
      counts.flat = 0;
      counts.cube = 0;
      counts.plain = 0;
      addLights('flat');
      addLights('cube');
      addLights(null);
      fitShader();
    },
    dispose: () => {},
  };
}

/** Glass and the like let shadows through to what lies behind. */
export function catchesShadows(master: Drawable, item: ObjectItem): boolean {
  return item.role === 'phantom' || materialsOf(master).every(isOpaque);
}

/** Draws a surface as a shadow. */
export function createCatcherMaterial(
  fragmentShader: string,
  uniforms: ShaderMaterial['uniforms'],
  occlusion: ShaderPatch | null,
): ShaderMaterial {
  const material = new ShaderMaterial({ name: 'shadow catcher', vertexShader: CATCHER_VERTEX, fragmentShader });
  material.uniforms = uniforms;
  material.defines = { PREMULTIPLIED_OUTPUT: '' };
  // After the depth pass of all phantoms, which lies a little behind: each pixel belongs to the nearest phantom, once.
  material.transparent = true;
  material.depthFunc = LessDepth;
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  patchMaterial(material, null, occlusion ? [occlusion] : []);
  return material;
}

/** What a catcher follows of the material whose place it takes. */
export function followSides(material: Material, master: Material): void {
  material.side = master.side;
  material.visible = master.visible;
}
