import {
  BackSide,
  BoxGeometry,
  CubeCamera,
  type CubeTexture,
  HalfFloatType,
  LinearMipmapLinearFilter,
  LinearSRGBColorSpace,
  Mesh,
  NoBlending,
  ShaderMaterial,
  type Texture,
  WebGLCubeRenderTarget,
} from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/runtime.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { PREFILTER_VERTEX, SAMPLED_FRAGMENT, SUMMED_FRAGMENT, UNFOLD_FRAGMENT } from './prefilter-shader.ts';

/** A panorama as rough surfaces mirror it, one level per roughness, and as matt ones receive it, in the last. */
export interface Prefiltered {
  readonly texture: Texture;
  dispose(): void;
}

/** Sharpest level: the smallest serves small pictures, the largest is 0.35° a pixel. */
const MIN_FACE_PX = 64;
const MAX_FACE_PX = 256;
/** The roughest level holds irradiance; three makes it of this size too. */
const ROUGHEST_FACE_PX = 8;
/** So many of the roughest levels sum up the whole surroundings, texel by texel; lobes of the others are narrow enough to sample. */
const SUMMED_LEVELS = 2;
/** Side of the faces that are summed up. */
const SUMMED_FACE_PX = 16;

/**
 * Filters a panorama for image-based lighting, in the layout that three's materials read (`PMREMGenerator.lodToRoughness`).
 *
 * three's own `PMREMGenerator` (r187) gives the same picture (`tests/slow/panoramas.test.ts` compares them), but for at least 256
 * pixels a face and with 256 samples each: 37 million in all, which took 10 s on a busy machine without a graphics processor. This
 * takes a third of them for large panoramas and a tenth for small ones.
 */
export function prefilter(renderer: SceneRenderer, { texture, widthPx }: EnvironmentAsset): Prefiltered {
  const facePx = Math.min(Math.max(2 ** Math.floor(Math.log2(widthPx / 4)), MIN_FACE_PX), MAX_FACE_PX);
  const source = createTarget(facePx, true);
  const target = createTarget(facePx, false);
  const sizes: number[] = [];
  for (let size = facePx; size >= ROUGHEST_FACE_PX; size /= 2) sizes.push(size);
  // Sizes are all that three reads of a target's levels.
  target.texture.mipmaps = sizes.map((size) => ({ width: size, height: size })) as unknown as CubeTexture[];
  target.texture.isPMREMTexture = true;

  const unfold = createMaterial('panorama to cube', UNFOLD_FRAGMENT, {
    panorama: { value: texture },
    // Texels of the panorama for one of the cube's, seen at its middle.
    level: { value: Math.max(0, Math.log2(widthPx / (4 * facePx))) },
  });
  const cube = { value: source.texture };
  const sampled = createMaterial('sampled roughness', SAMPLED_FRAGMENT, { cube, roughness: { value: 0 }, facePx: { value: facePx } });
  const summed = createMaterial('summed roughness', SUMMED_FRAGMENT, {
    cube,
    roughness: { value: 0 },
    facePx: { value: SUMMED_FACE_PX },
    level: { value: Math.log2(facePx / SUMMED_FACE_PX) },
  });
  const box = new Mesh(new BoxGeometry(2, 2, 2), unfold);
  renderer.work((three) => {
    new CubeCamera(0.1, 10, source).update(three, box);
    const camera = new CubeCamera(0.1, 10, target);
    sizes.forEach((size, level) => {
      const roughness = roughnessOf(level, sizes.length - 1);
      const material = level < sizes.length - SUMMED_LEVELS ? sampled : summed;
      setUniform(material, 'roughness', roughness);
      box.material = material;
      target.viewport.set(0, 0, size, size);
      camera.activeMipmapLevel = level;
      camera.update(three, box);
    });
  });
  target.viewport.set(0, 0, facePx, facePx);
  for (const part of [source, box.geometry, unfold, sampled, summed]) part.dispose();
  return { texture: target.texture, dispose: () => target.dispose() };
}

/** `PMREMGenerator.lodToRoughness`, which the published types lack. */
function roughnessOf(level: number, lastLevel: number): number {
  return 1 - Math.sqrt(1 - level / lastLevel);
}

function createTarget(facePx: number, generateMipmaps: boolean): WebGLCubeRenderTarget {
  return new WebGLCubeRenderTarget(facePx, {
    type: HalfFloatType,
    colorSpace: LinearSRGBColorSpace,
    minFilter: LinearMipmapLinearFilter,
    generateMipmaps,
    depthBuffer: false,
  });
}

function createMaterial(name: string, fragmentShader: string, uniforms: ShaderMaterial['uniforms']): ShaderMaterial {
  return new ShaderMaterial({
    name,
    vertexShader: PREFILTER_VERTEX,
    fragmentShader,
    uniforms,
    side: BackSide,
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });
}

function setUniform(material: ShaderMaterial, name: string, value: number): void {
  const uniform = material.uniforms[name];
  if (uniform) uniform.value = value;
}
