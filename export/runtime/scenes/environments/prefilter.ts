import { BoxGeometry, CubeCamera, Mesh, type ShaderMaterial, type Texture, type WebGLCubeRenderTarget, type WebGLRenderer } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createCubeMaterial, createCubeTarget, createPmremTarget } from './pmrem-target.ts';
import { SAMPLED_FRAGMENT, SUMMED_FRAGMENT, UNFOLD_FRAGMENT } from './prefilter-shader.ts';

/** A panorama convolved for rough surfaces, one level per roughness; the last level is for matte surfaces. */
export interface Prefiltered {
  readonly texture: Texture;
  dispose(): void;
}

/** Limits of the size of the sharpest level, which depends on the size of the panorama. At the maximum, a pixel covers 0.35°. */
const MIN_FACE_PX = 64;
const MAX_FACE_PX = 256;
/** Size of the roughest level, which holds irradiance; three.js uses the same. */
const ROUGHEST_FACE_PX = 8;
/** Number of rough levels that sum all texels; the lobes of the others are narrow enough to sample. */
const SUMMED_LEVELS = 2;
/** Size of the faces that are summed. */
const SUMMED_FACE_PX = 16;

/**
 * Filters a panorama for image-based lighting, in the layout that three.js' materials read.
 *
 * three.js' `PMREMGenerator` (r187) gives the same image (`tests/slow/panoramas.test.ts` compares them), but uses at least 256 pixels per
 * face and 256 samples each: 37 million in total, which took 10 s on a busy machine without a GPU. This takes a third of the samples for
 * large panoramas and a tenth for small ones.
 */
export function prefilter(renderer: SceneRenderer, { texture, widthPx }: Pick<EnvironmentAsset, 'texture' | 'widthPx'>): Prefiltered {
  const facePx = Math.min(Math.max(2 ** Math.floor(Math.log2(widthPx / 4)), MIN_FACE_PX), MAX_FACE_PX);
  const levels = Math.log2(facePx / ROUGHEST_FACE_PX) + 1;
  const source = createCubeTarget(facePx, true);
  const target = createPmremTarget(facePx, ROUGHEST_FACE_PX);
  const unfold = createCubeMaterial('panorama to cube', UNFOLD_FRAGMENT, {
    panorama: { value: texture },
    // Mip level whose texels have the size of the cube map's at its center.
    level: { value: Math.max(0, Math.log2(widthPx / (4 * facePx))) },
  });
  const filler = createCubeFiller(source, unfold);
  const cube = { value: source.texture };
  const sampled = createSampledMaterial(cube, facePx);
  const summed = createCubeMaterial('summed roughness', SUMMED_FRAGMENT, {
    cube,
    roughness: { value: 0 },
    facePx: { value: SUMMED_FACE_PX },
    level: { value: Math.log2(facePx / SUMMED_FACE_PX) },
  });
  renderer.work((three) => {
    filler.fill(three);
    target.draw(three, (roughness, level) => withRoughness(level < levels - SUMMED_LEVELS ? sampled : summed, roughness));
  });
  for (const part of [source, filler, unfold, sampled, summed]) part.dispose();
  return target;
}

/** Creates a material that convolves a cube map with mip levels, `facePx` per side. */
export function createSampledMaterial(cube: { readonly value: Texture }, facePx: number): ShaderMaterial {
  return createCubeMaterial('sampled roughness', SAMPLED_FRAGMENT, { cube, roughness: { value: 0 }, facePx: { value: facePx } });
}

export function withRoughness(material: ShaderMaterial, roughness: number): ShaderMaterial {
  const uniform = material.uniforms.roughness;
  if (uniform) uniform.value = roughness;
  return material;
}

/** Draws all faces of a cube map's sharpest level; the other levels are generated. */
export interface CubeFiller {
  fill(three: WebGLRenderer): void;
  dispose(): void;
}

/** Creates what draws the faces of `target` with `material`. The caller disposes both. */
export function createCubeFiller(target: WebGLCubeRenderTarget, material: ShaderMaterial): CubeFiller {
  const box = new Mesh(new BoxGeometry(2, 2, 2), material);
  const camera = new CubeCamera(0.1, 10, target);
  return { fill: (three) => camera.update(three, box), dispose: () => box.geometry.dispose() };
}
