import type { MutableLight, MutableReflection } from '../session-frame.ts';
import { turnHarmonics } from './turn-harmonics.ts';
import type { XrBinding, XrFrameWithLight, XrLightProbe, XrSessionWithLight } from './webxr-types.ts';

/** The light that the browser estimates, in world space; null while it has none. */
export interface WebXrLight {
  /** `binding`: of the context that draws; null where the browser has none. */
  read(frame: XRFrame, referenceSpace: XRReferenceSpace, binding: XrBinding | null): MutableLight | null;
}

/** Of a rotation's elements: a change below it, a tenth of a degree, is not worth filtering a cube map anew. */
const SEEN_TURN = 0.002;

/**
 * All of it is told in the axes of the probe. These are the world's until that is re-centered; so coefficients and direction are
 * turned, in WebXR's own order, and of the cube map it is said how it lies.
 */
export function createWebXrLight(session: XrSessionWithLight): WebXrLight {
  let probe: XrLightProbe | null = null;
  /** Of which binding the cube map was taken; a context that was lost and is back has another. */
  let reflectedBy: XrBinding | null = null;
  const format = session.preferredReflectionFormat;
  session.requestLightProbe?.(format ? { reflectionFormat: format } : {}).then(
    (granted) => {
      probe = granted;
      granted.addEventListener('reflectionchange', () => {
        reflectedBy = null;
      });
    },
    // Not granted: there is no light, as the program's need says.
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
    // One that shows something else is told by its version, whether or not it is another texture.
    reflection = texture === null ? null : { texture, version: (reflection?.version ?? 0) + 1 };
    return reflection;
  };
  /** A cube map that lies otherwise shows something else. */
  const turnReflection = (turned: MutableReflection, worldFromProbe: Float32Array): void => {
    turned.cubeFromWorld ??= Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
    const { cubeFromWorld } = turned;
    if (!differs(cubeFromWorld, worldFromProbe)) return;
    // The inverse of a rotation is its transpose.
    for (let i = 0; i < 9; i++) cubeFromWorld[i] = worldFromProbe[Math.floor(i / 3) + (i % 3) * 4] ?? 0;
    turned.version++;
  };
  return {
    read: (frame: XrFrameWithLight, referenceSpace, binding) => {
      const estimate = probe ? frame.getLightEstimate?.(probe) : null;
      if (!probe || !estimate) return null;
      const { x, y, z } = estimate.primaryLightDirection;
      const m = frame.getPose(probe.probeSpace, referenceSpace)?.transform.matrix ?? AS_IT_IS;
      turnHarmonics(light.sphericalHarmonics, estimate.sphericalHarmonicsCoefficients, m);
      for (let row = 0; row < 3; row++) {
        light.primaryDirectionWorld[row] = (m[row] ?? 0) * x + (m[row + 4] ?? 0) * y + (m[row + 8] ?? 0) * z;
      }
      light.primaryIntensity[0] = estimate.primaryLightIntensity.x;
      light.primaryIntensity[1] = estimate.primaryLightIntensity.y;
      light.primaryIntensity[2] = estimate.primaryLightIntensity.z;
      light.reflection = readReflection(probe, binding);
      if (light.reflection) turnReflection(light.reflection, m);
      return light;
    },
  };
}

const AS_IT_IS = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

function differs(cubeFromWorld: Float32Array, worldFromProbe: Float32Array): boolean {
  for (let i = 0; i < 9; i++) {
    if (Math.abs((cubeFromWorld[i] ?? 0) - (worldFromProbe[Math.floor(i / 3) + (i % 3) * 4] ?? 0)) > SEEN_TURN) return true;
  }
  return false;
}
