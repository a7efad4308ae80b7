import type { MutableLight, MutableReflection } from '../session-frame.ts';
import type { XrBinding, XrFrameWithLight, XrLightProbe, XrSessionWithLight } from './webxr-types.ts';

/** The light that the browser estimates, in world space; null while it has none. */
export interface WebXrLight {
  /** `binding`: of the context that draws; null where the browser has none. */
  read(frame: XRFrame, world: XRReferenceSpace, binding: XrBinding | null): MutableLight | null;
}

/**
 * Coefficients are handed on in WebXR's own order and as they are: a probe's axes are those of the local space. Only the
 * direction is turned, for spaces that were re-centred since.
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
  return {
    read: (frame: XrFrameWithLight, world, binding) => {
      const estimate = probe ? frame.getLightEstimate?.(probe) : null;
      if (!probe || !estimate) return null;
      light.sphericalHarmonics.set(estimate.sphericalHarmonicsCoefficients);
      const { x, y, z } = estimate.primaryLightDirection;
      const m = frame.getPose(probe.probeSpace, world)?.transform.matrix;
      for (let row = 0; row < 3; row++) {
        light.primaryDirectionWorld[row] = m ? (m[row] ?? 0) * x + (m[row + 4] ?? 0) * y + (m[row + 8] ?? 0) * z : 0;
      }
      if (!m) {
        light.primaryDirectionWorld[0] = x;
        light.primaryDirectionWorld[1] = y;
        light.primaryDirectionWorld[2] = z;
      }
      light.primaryIntensity[0] = estimate.primaryLightIntensity.x;
      light.primaryIntensity[1] = estimate.primaryLightIntensity.y;
      light.primaryIntensity[2] = estimate.primaryLightIntensity.z;
      light.reflection = readReflection(probe, binding);
      return light;
    },
  };
}
