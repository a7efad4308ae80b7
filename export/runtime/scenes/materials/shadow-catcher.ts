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
import type { LightItem, LightList, NumberView, VectorView } from '../../../../nodes/kit/runtime.ts';
import type { RenderedShadowMaps, ShadowMap } from '../lights/shadow-maps.ts';
import { patchMaterial, type ShaderPatch } from './shader-patch.ts';
import { CATCHER_VERTEX, catcherFragment } from './shadow-catcher-shader.ts';
import type { Twin } from './twins.ts';

/** The materials of one shadow layer: they share lights, strength and colour, and differ in what three compiles per object. */
export interface ShadowCatcher {
  createTwin(master: Material): Twin;
  /** Takes over strength, colour, lights and maps. */
  update(lists: readonly LightList[], maps: RenderedShadowMaps | null): void;
}

// Rec. 709 luminance of linear-sRGB.
const LUMINANCE = new Vector3(0.2126, 0.7152, 0.0722);

// Read by the call that fills them, before anything else can.
const scratchRadiance = new Vector3();
const scratchDirection = new Vector3();

export function createShadowCatcher(strength: NumberView, color: VectorView, occlusion: ShaderPatch | null): ShadowCatcher {
  const shadowMaps: (Texture | null)[] = [];
  const mapFromWorld: Matrix4[] = [];
  const mapBias: Vector3[] = [];
  const shadowedLights: Vector4[] = [];
  const plainLights: Vector4[] = [];
  const uniforms = {
    strength: { value: 0 },
    shadowColor: { value: new Vector4() },
    shadowMaps: { value: shadowMaps },
    mapFromWorld: { value: mapFromWorld },
    mapBias: { value: mapBias },
    shadowedLights: { value: shadowedLights },
    plainLights: { value: plainLights },
  };
  let compiled = { shadowed: 0, plain: 0 };
  let fragmentShader = catcherFragment(0, 0);
  const materials: ShaderMaterial[] = [];
  let shadowed = 0;
  let plain = 0;

  function addShadowed(light: LightItem, map: ShadowMap): void {
    const i = shadowed++;
    shadowMaps[i] = map.target.depthTexture;
    mapFromWorld[i] = map.mapFromWorld;
    mapBias[i] ??= new Vector3();
    mapBias[i].set(1 / map.shadow.mapSizePx, map.shadow.bias, map.shadow.normalBiasM);
    shadowedLights[i] = describe(light, shadowedLights[i]);
  }

  function addPlain(light: LightItem): void {
    const i = plain++;
    plainLights[i] = describe(light, plainLights[i]);
  }

  /** The shader is written for its lights; their number changes when one comes, goes, or begins to cast a shadow. */
  function fitShader(): void {
    if (shadowed === compiled.shadowed && plain === compiled.plain) return;
    compiled = { shadowed, plain };
    for (const array of [shadowMaps, mapFromWorld, mapBias, shadowedLights]) array.length = shadowed;
    plainLights.length = plain;
    fragmentShader = catcherFragment(shadowed, plain);
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
      shadowed = 0;
      plain = 0;
      for (const list of lists) {
        for (const light of list.items) {
          const map = maps?.mapOf(light) ?? null;
          if (map) addShadowed(light, map);
          else addPlain(light);
        }
      }
      fitShader();
    },
  };
}

function describe(light: LightItem, into = new Vector4()): Vector4 {
  const { x, y, z } = scratchDirection.fromArray(light.towardsLightWorld);
  return into.set(x, y, z, scratchRadiance.fromArray(light.radiance).dot(LUMINANCE));
}
