import { CubeTexture, Matrix3, type ShaderMaterial, type Texture, Vector3, type WebGLCubeRenderTarget } from 'three';
import type { ProbeLightItem } from '../../../../nodes/kit/scene-lists.ts';
import type { ReflectionCube } from '../../../../nodes/kit/session.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createCubeMaterial, createCubeTarget, createPmremTarget } from './pmrem-target.ts';
import { createCubeFiller, createSampledMaterial, withRoughness } from './prefilter.ts';
import { HARMONICS_FRAGMENT, REFLECTION_FRAGMENT } from './probe-shader.ts';

/** A light estimate in the form that three.js' materials read. */
export interface ProbeEnvironment {
  readonly texture: Texture;
  /** Updates to the current estimate; draws only levels that changed visibly. */
  update(light: ProbeLightItem): void;
  dispose(): void;
}

/** Size of the sharpest level. Devices provide 16 to 64 pixels per face. */
const FACE_PX = 128;
/**
 * Size of the level that lights matte surfaces, read with linear filtering. With 8 pixels per face a second-order harmonic has an error of
 * 2 % between texels, with 16 of 0.5 %, which is below one step of 255.
 */
const IRRADIANCE_FACE_PX = 16;
const LAST_LEVEL = Math.log2(FACE_PX / IRRADIANCE_FACE_PX);

/** Threshold for a change of a coefficient, relative to the mean radiance: smaller changes alter no pixel by a step of 255. */
const SEEN_PART = 1 / 1000;

/**
 * Factors by which a convolution with the clamped cosine, divided by π, scales the three bands of spherical harmonics (Ramamoorthi and
 * Hanrahan 2001, eq. 8).
 */
const COSINE_BANDS = new Vector3(1, 2 / 3, 1 / 4);

/**
 * Creates the environment of a light estimate. The last level holds the irradiance of the spherical harmonics. The other levels come from
 * the cube map, or from the harmonics if there is none, so that the same light is not added twice.
 */
export function createProbeEnvironment(renderer: SceneRenderer): ProbeEnvironment {
  const target = createPmremTarget(FACE_PX, IRRADIANCE_FACE_PX);
  const harmonics = Array.from({ length: 9 }, () => new Vector3());
  const bands = new Vector3();
  const byHarmonics = createCubeMaterial('light estimate', HARMONICS_FRAGMENT, {
    harmonics: { value: harmonics },
    bands: { value: bands },
  });
  const drawn = new Float32Array(27).fill(Number.NaN);
  let mirrored: MirroredCube | null = null;
  let drawnVersion = 0;

  function materialFor(roughness: number, level: number): ShaderMaterial {
    if (level === LAST_LEVEL) {
      bands.copy(COSINE_BANDS);
      return byHarmonics;
    }
    if (mirrored && drawnVersion !== 0) return withRoughness(mirrored.sampled, roughness);
    setLobeBands(bands, roughness);
    return byHarmonics;
  }

  function mirror(reflection: ReflectionCube | null): void {
    drawnVersion = reflection?.version ?? 0;
    if (!reflection) return;
    mirrored ??= createMirroredCube();
    mirrored.fill(renderer, reflection);
  }

  return {
    texture: target.texture,
    update: ({ sphericalHarmonics, reflection }) => {
      const isOther = (reflection?.version ?? 0) !== drawnVersion;
      if (!isOther && !differs(drawn, sphericalHarmonics)) return;
      drawn.set(sphericalHarmonics);
      for (let i = 0; i < 9; i++) harmonics[i]?.fromArray(drawn, i * 3);
      if (isOther) mirror(reflection);
      // Coefficients change in every frame and do not affect levels of a cube map.
      const fromLevel = isOther || drawnVersion === 0 ? 0 : LAST_LEVEL;
      renderer.work((three) => target.draw(three, materialFor, fromLevel));
    },
    dispose: () => {
      target.dispose();
      byHarmonics.dispose();
      mirrored?.dispose();
    },
  };
}

/**
 * Sets the factors by which a blur with a GGX lobe scales the three bands of spherical harmonics. The lobe is approximated by a spherical
 * Gaussian of sharpness 1 / (2 α²): Wang et al. 2009, section 4.
 */
function setLobeBands(bands: Vector3, roughness: number): void {
  const spread = 2 * roughness ** 4;
  bands.set(1, Math.exp(-spread), Math.exp(-3 * spread));
}

function differs(drawn: Float32Array, now: Float32Array): boolean {
  const step = SEEN_PART * Math.max(Math.abs(drawn[0] ?? 0), Math.abs(drawn[1] ?? 0), Math.abs(drawn[2] ?? 0));
  for (let i = 0; i < now.length; i++) {
    // NaN means that nothing was drawn.
    if (!(Math.abs((now[i] ?? 0) - (drawn[i] ?? 0)) <= step)) return true;
  }
  return false;
}

/** The session's cube map, copied to one with mip levels. */
interface MirroredCube {
  readonly sampled: ShaderMaterial;
  fill(renderer: SceneRenderer, reflection: ReflectionCube): void;
  dispose(): void;
}

function createMirroredCube(): MirroredCube {
  const source: WebGLCubeRenderTarget = createCubeTarget(FACE_PX, true);
  // three.js uploads nothing to a texture of version 0 and binds its GL texture.
  const given = new CubeTexture();
  const cubeFromWorld = new Matrix3();
  const unfold = createCubeMaterial('reflection', REFLECTION_FRAGMENT, {
    reflection: { value: given },
    cubeFromWorld: { value: cubeFromWorld },
  });
  const filler = createCubeFiller(source, unfold);
  const sampled = createSampledMaterial({ value: source.texture }, FACE_PX);
  return {
    sampled,
    fill: (renderer, { texture, cubeFromWorld: turn }) => {
      if (turn) cubeFromWorld.fromArray(turn);
      else cubeFromWorld.identity();
      renderer.work((three) => {
        Object.assign(three.properties.get(given) as object, { __webglTexture: texture });
        filler.fill(three);
      });
    },
    dispose: () => {
      for (const part of [source, filler, unfold, sampled]) part.dispose();
    },
  };
}
