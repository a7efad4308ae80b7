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
import type { EnvironmentLightItem, LightItem, LightList, NumberView, VectorView } from '../../../../nodes/kit/runtime.ts';
import type { ShadowMap } from '../lights/light-map.ts';
import { MIN_PENUMBRA } from '../lights/light-rig.ts';
import type { RenderedShadowMaps } from '../lights/shadow-maps.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { CATCHER_VERTEX, type CatcherLights, catcherFragment } from './shadow-catcher-shader.ts';
import type { Twin } from './twins.ts';

/** The materials of one shadow layer: they share lights, strength and colour, and differ in what three compiles per object. */
export interface ShadowCatcher {
  createTwin(master: Material): Twin;
  /** Takes over strength, colour, lights and maps. */
  update(lists: readonly LightList[], maps: RenderedShadowMaps | null): void;
}

// Rec. 709 luminance of linear-sRGB.
const LUMINANCE = new Vector3(0.2126, 0.7152, 0.0722);

// Read by the call that fills it, before anything else can.
const scratchColor = new Vector3();

type Lamp = Exclude<LightItem, EnvironmentLightItem>;

export function createShadowCatcher(strength: NumberView, color: VectorView, occlusion: ShaderPatch | null): ShadowCatcher {
  const lightPlace: Vector4[] = [];
  const lightCone: Vector4[] = [];
  const lightFall: Vector3[] = [];
  const flatMaps: (Texture | null)[] = [];
  const mapFromWorld: Matrix4[] = [];
  const flatBias: Vector3[] = [];
  const cubeMaps: (Texture | null)[] = [];
  const cubeReach: Vector4[] = [];
  const uniforms = {
    strength: { value: 0 },
    shadowColor: { value: new Vector4() },
    lightPlace: { value: lightPlace },
    lightCone: { value: lightCone },
    lightFall: { value: lightFall },
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
  function addLights(lists: readonly LightList[], maps: RenderedShadowMaps | null, wanted: ShadowMap['kind'] | null): void {
    for (const list of lists) {
      for (const light of list.items) {
        if (light.kind === 'environment') continue;
        const map = maps?.mapOf(light) ?? null;
        if ((map?.kind ?? null) !== wanted) continue;
        describe(light, counts.flat + counts.cube + counts.plain);
        if (map === null) counts.plain++;
        else if (map.kind === 'flat') addFlat(map);
        else addCube(map);
      }
    }
  }

  function describe(light: Lamp, i: number): void {
    lightPlace[i] ??= new Vector4();
    lightCone[i] ??= new Vector4();
    lightFall[i] ??= new Vector3();
    describeLamp(light, lightPlace[i], lightCone[i], lightFall[i]);
  }

  /** The shader is written for its lights; their number changes when one comes, goes, or begins to cast a shadow. */
  function fitShader(): void {
    const { flat, cube, plain } = counts;
    if (flat === compiled.flat && cube === compiled.cube && plain === compiled.plain) return;
    compiled = { flat, cube, plain };
    for (const array of [flatMaps, mapFromWorld, flatBias]) array.length = flat;
    for (const array of [cubeMaps, cubeReach]) array.length = cube;
    for (const array of [lightPlace, lightCone, lightFall]) array.length = flat + cube + plain;
    fragmentShader = catcherFragment(compiled);
    for (const material of materials) {
      material.fragmentShader = fragmentShader;
      material.needsUpdate = true;
    }
  }

  return {
    createTwin: (master) => {
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
      materials.push(material);
      const sync = (): void => {
        material.side = master.side;
        material.visible = master.visible;
      };
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
    update: (lists, maps) => {
      uniforms.strength.value = strength.value;
      uniforms.shadowColor.value.fromArray(color.value);
      counts.flat = 0;
      counts.cube = 0;
      counts.plain = 0;
      addLights(lists, maps, 'flat');
      addLights(lists, maps, 'cube');
      addLights(lists, maps, null);
      fitShader();
    },
  };
}

const NO_CONE = -2;

function describeLamp(light: Lamp, place: Vector4, cone: Vector4, fall: Vector3): void {
  cone.set(0, 0, 0, NO_CONE);
  if (light.kind === 'directional') {
    const [x = 0, y = 0, z = 0] = light.towardsLightWorld;
    place.set(x, y, z, 0);
    fall.set(luminanceOf(light.radiance), 0, 0);
    return;
  }
  const [x = 0, y = 0, z = 0] = light.positionWorld;
  place.set(x, y, z, 1);
  fall.set(luminanceOf(light.intensityCd), light.rangeM, 0);
  if (light.kind !== 'spot') return;
  const [towardsX = 0, towardsY = 0, towardsZ = 0] = light.towardsLightWorld;
  cone.set(towardsX, towardsY, towardsZ, Math.cos(light.halfAngleRad));
  fall.z = Math.cos(light.halfAngleRad * (1 - Math.max(light.penumbra, MIN_PENUMBRA)));
}

function luminanceOf(color: Float32Array): number {
  return scratchColor.fromArray(color).dot(LUMINANCE);
}
