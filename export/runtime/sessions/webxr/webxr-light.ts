import type { MutableLight, MutableReflection } from '../session-frame.ts';
import { rotateHarmonics } from './rotate-harmonics.ts';
import type { XrBinding, XrFrameWithLight, XrLightProbe, XrSessionWithLight } from './webxr-types.ts';

/** Reads the estimated light in world space. */
export interface WebXrLight {
  /**
   * Returns the light of a frame; null without an estimate. `binding` belongs to the context that draws; it is null if the browser has
   * none.
   */
  read(frame: XRFrame, referenceSpace: XRReferenceSpace, binding: XrBinding | null): MutableLight | null;
}

/**
 * Threshold for elements of a rotation matrix: about a tenth of a degree. Smaller changes do not cause the cube map to be filtered again.
 */
const MIN_ROTATION = 0.002;

/**
 * Creates the reader of the light estimate. WebXR gives it in probe space, which differs from world space after the visitor re-centers.
 * Coefficients and direction are rotated to world space; with the cube map, the rotation is returned.
 */
export function createWebXrLight(session: XrSessionWithLight): WebXrLight {
  let probe: XrLightProbe | null = null;
  /** The binding that returned the current cube map; null if the map must be read again. A restored context has another binding. */
  let reflectedBy: XrBinding | null = null;
  const format = session.preferredReflectionFormat;
  session.requestLightProbe?.(format ? { reflectionFormat: format } : {}).then(
    (granted) => {
      probe = granted;
      granted.addEventListener('reflectionchange', () => {
        reflectedBy = null;
      });
    },
    // Not granted: no light, which the program's need already reports.
    () => {},
  );
  let reflection: MutableReflection | null = null;
  const light: MutableLight = {
    sphericalHarmonics: new Float32Array(27),
    primaryDirectionWorld: new Float32Array(3),
    primaryIntensity: new Float32Array(3),
    reflection: null,
  };
  const readReflection = (from: XrLightProbe, binding: XrBinding | null): MutableReflection | null => {
    if (binding === null || binding === reflectedBy) return binding === null ? null : reflection;
    reflectedBy = binding;
    const texture = binding.getReflectionCubeMap?.(from) ?? null;
    // The version changes with the content, even if the texture object stays.
    reflection = texture === null ? null : { texture, version: (reflection?.version ?? 0) + 1 };
    return reflection;
  };
  /** Updates the rotation of the cube map. A changed rotation counts as new content. */
  const rotateReflection = (rotated: MutableReflection, worldFromProbe: Float32Array): void => {
    rotated.cubeFromWorld ??= Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
    const { cubeFromWorld } = rotated;
    if (!differs(cubeFromWorld, worldFromProbe)) return;
    // The inverse of a rotation is its transpose.
    for (let i = 0; i < 9; i++) cubeFromWorld[i] = worldFromProbe[Math.floor(i / 3) + (i % 3) * 4] ?? 0;
    rotated.version++;
  };
  return {
    read: (frame: XrFrameWithLight, referenceSpace, binding) => {
      const estimate = probe ? frame.getLightEstimate?.(probe) : null;
      if (!probe || !estimate) return null;
      const { x, y, z } = estimate.primaryLightDirection;
      const m = frame.getPose(probe.probeSpace, referenceSpace)?.transform.matrix ?? AS_IT_IS;
      rotateHarmonics(light.sphericalHarmonics, estimate.sphericalHarmonicsCoefficients, m);
      for (let row = 0; row < 3; row++) {
        light.primaryDirectionWorld[row] = (m[row] ?? 0) * x + (m[row + 4] ?? 0) * y + (m[row + 8] ?? 0) * z;
      }
      light.primaryIntensity[0] = estimate.primaryLightIntensity.x;
      light.primaryIntensity[1] = estimate.primaryLightIntensity.y;
      light.primaryIntensity[2] = estimate.primaryLightIntensity.z;
      light.reflection = readReflection(probe, binding);
      if (light.reflection) rotateReflection(light.reflection, m);
      return light;
    },
  };
}

const AS_IT_IS = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

function differs(cubeFromWorld: Float32Array, worldFromProbe: Float32Array): boolean {
  for (let i = 0; i < 9; i++) {
    if (Math.abs((cubeFromWorld[i] ?? 0) - (worldFromProbe[Math.floor(i / 3) + (i % 3) * 4] ?? 0)) > MIN_ROTATION) return true;
  }
  return false;
}
