import { CubeTexture, Matrix3, type ShaderMaterial, type Texture, Vector3, type WebGLCubeRenderTarget } from 'three';
import type { ProbeLightItem } from '../../../../nodes/kit/scene-lists.ts';
import type { ReflectionCube } from '../../../../nodes/kit/session.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { createCubeMaterial, createCubeTarget, createPmremTarget } from './pmrem-target.ts';
import { createCubeFiller, createSampledMaterial, withRoughness } from './prefilter.ts';
import { HARMONICS_FRAGMENT, REFLECTION_FRAGMENT } from './probe-shader.ts';

/** A measured light in the form that three's materials are lit with. */
export interface ProbeEnvironment {
  readonly texture: Texture;
  /** Takes over what the light is now; draws only where it shows. */
  update(light: ProbeLightItem): void;
  dispose(): void;
}

/** What devices give has 16 to 64 pixels a face. */
const FACE_PX = 128;
/**
 * Of the level that lights matt surfaces, read with linear filtering: at 8 pixels a face, a second-order harmonic is off by 2 % of
 * its size between texels, at 16 by 0.5 %, which is below one step of 255.
 */
const IRRADIANCE_FACE_PX = 16;
const LAST_LEVEL = Math.log2(FACE_PX / IRRADIANCE_FACE_PX);

/** Of the mean radiance: a change below it, in any coefficient, moves no pixel by a step of 255. */
const SEEN_PART = 1 / 1000;

/** What the clamped cosine leaves of the bands, over π: its integral over radiance is irradiance (Ramamoorthi and Hanrahan 2001, eq. 8). */
const COSINE_BANDS = new Vector3(1, 2 / 3, 1 / 4);

/**
 * The last level is the irradiance of the harmonics, and what is mirrored comes from the cube map, else from the harmonics too: so
 * nine numbers and a cube map of one light are not added up as if they were two.
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
      // Coefficients change in every frame, and say nothing of what a cube map shows.
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

/** A surface that mirrors in a lobe of GGX, taken as a spherical Gaussian of sharpness 1 / (2 α²): Wang et al. 2009, section 4. */
function setLobeBands(bands: Vector3, roughness: number): void {
  const spread = 2 * roughness ** 4;
  bands.set(1, Math.exp(-spread), Math.exp(-3 * spread));
}

function differs(drawn: Float32Array, now: Float32Array): boolean {
  const step = SEEN_PART * Math.max(Math.abs(drawn[0] ?? 0), Math.abs(drawn[1] ?? 0), Math.abs(drawn[2] ?? 0));
  for (let i = 0; i < now.length; i++) {
    // Nothing has been drawn where it is not a number.
    if (!(Math.abs((now[i] ?? 0) - (drawn[i] ?? 0)) <= step)) return true;
  }
  return false;
}

/** The session's cube map with mip levels of ours. */
interface MirroredCube {
  readonly sampled: ShaderMaterial;
  fill(renderer: SceneRenderer, reflection: ReflectionCube): void;
  dispose(): void;
}

function createMirroredCube(): MirroredCube {
  const source: WebGLCubeRenderTarget = createCubeTarget(FACE_PX, true);
  // three uploads nothing into a texture of version 0, and binds what it finds at it.
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
