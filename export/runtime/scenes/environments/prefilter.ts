import { BoxGeometry, CubeCamera, Mesh, type ShaderMaterial, type Texture, type WebGLCubeRenderTarget, type WebGLRenderer } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { PartedWork } from '../../gl/spread-work.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createCubeMaterial, createCubeTarget, createPmremTarget, faceCamera } from './pmrem-target.ts';
import { SAMPLED_FRAGMENT, SAMPLES, SUMMED_FRAGMENT, UNFOLD_FRAGMENT } from './prefilter-shader.ts';

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

/** Samples that one turn takes, a sixth of what a desktop computer without a GPU takes per second. */
const TURN_SAMPLES = 2 ** 18;

/**
 * Filters a panorama for image-based lighting, in the layout that three.js' materials read. The parts are rows of its faces.
 *
 * three.js' `PMREMGenerator` (r187) gives the same image (`tests/slow/panoramas.test.ts` compares them), but uses at least 256 pixels per
 * face and 256 samples each: 37 million in total, which took 10 s on a busy machine without a GPU. This takes a third of the samples for
 * large panoramas and a tenth for small ones.
 */
export function* prefilter(
  renderer: SceneRenderer,
  { texture, widthPx }: Pick<EnvironmentAsset, 'texture' | 'widthPx'>,
): PartedWork<Prefiltered> {
  const facePx = Math.min(Math.max(2 ** Math.floor(Math.log2(widthPx / 4)), MIN_FACE_PX), MAX_FACE_PX);
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
  let isWhole = false;
  try {
    for (let face = 0; face < 6; face++) {
      renderer.work((three) => filler.fillFace(three, face));
      yield facePx ** 2 / TURN_SAMPLES;
    }
    for (const [level, { facePx: size, roughness }] of target.levels.entries()) {
      const isSummed = level >= target.levels.length - SUMMED_LEVELS;
      const material = withRoughness(isSummed ? summed : sampled, roughness);
      const samples = isSummed ? 6 * SUMMED_FACE_PX ** 2 : roughness === 0 ? 1 : SAMPLES;
      const most = Math.max(1, Math.floor(TURN_SAMPLES / (samples * size)));
      for (let face = 0; face < 6; face++) {
        for (let firstRow = 0; firstRow < size; firstRow += most) {
          const rows = Math.min(most, size - firstRow);
          renderer.work((three) => target.drawRows(three, material, { level, face, firstRow, rows }));
          yield (rows * size * samples) / TURN_SAMPLES;
        }
      }
    }
    isWhole = true;
    return target;
  } finally {
    for (const part of [source, filler, unfold, sampled, summed]) part.dispose();
    if (!isWhole) target.dispose();
  }
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
  /** Draws one face. The other levels are generated after the last one. */
  fillFace(three: WebGLRenderer, face: number): void;
  dispose(): void;
}

/** Creates what draws the faces of `target` with `material`. The caller disposes both. */
export function createCubeFiller(target: WebGLCubeRenderTarget, material: ShaderMaterial): CubeFiller {
  const box = new Mesh(new BoxGeometry(2, 2, 2), material);
  const camera = new CubeCamera(0.1, 10, target);
  return {
    fill: (three) => camera.update(three, box),
    fillFace: (three, face) => {
      const { texture } = target;
      texture.mipmapsAutoUpdate = face === 5;
      three.setRenderTarget(target, face);
      three.render(box, faceCamera(three, camera, face));
      texture.mipmapsAutoUpdate = true;
    },
    dispose: () => box.geometry.dispose(),
  };
}
