import type { XRSpace } from 'iwer';
import type { EstimatedLight } from './session-light.ts';

export type ReflectionFormat = 'srgba8' | 'rgba16f';

/** `XRLightProbe` of WebXR Lighting Estimation §2.1. */
export class EmulatedLightProbe extends EventTarget {
  readonly probeSpace: XRSpace;
  #onreflectionchange: ((event: Event) => void) | null = null;

  constructor(probeSpace: XRSpace) {
    super();
    this.probeSpace = probeSpace;
  }

  get onreflectionchange(): ((event: Event) => void) | null {
    return this.#onreflectionchange;
  }

  set onreflectionchange(listener: ((event: Event) => void) | null) {
    if (this.#onreflectionchange) this.removeEventListener('reflectionchange', this.#onreflectionchange);
    this.#onreflectionchange = listener;
    if (listener) this.addEventListener('reflectionchange', listener);
  }
}

/** `XRLightEstimate` of WebXR Lighting Estimation §2.3, in the space of the probe, whose axes are those of the world. */
export class EmulatedLightEstimate {
  readonly sphericalHarmonicsCoefficients: Float32Array;
  readonly primaryLightDirection: DOMPointReadOnly;
  readonly primaryLightIntensity: DOMPointReadOnly;

  /** Without an estimated direction the light comes from above; without an intensity it is 0. */
  constructor({ sphericalHarmonics, directionWorld, intensity }: EstimatedLight) {
    const [x, y, z] = directionWorld ?? [0, 1, 0];
    const [r, g, b] = intensity ?? [0, 0, 0];
    this.sphericalHarmonicsCoefficients = sphericalHarmonics;
    this.primaryLightDirection = new DOMPointReadOnly(x, y, z, 0);
    this.primaryLightIntensity = new DOMPointReadOnly(r, g, b, 1);
  }
}

/** Session and format of a probe. It is stored separately because pages see the probe itself. */
export interface ProbeState {
  readonly session: EventTarget;
  readonly format: ReflectionFormat;
  /** Whether the cube map changed and `reflectionchange` was not dispatched yet. */
  changed: boolean;
}

const states = new WeakMap<EmulatedLightProbe, ProbeState>();

export function createLightProbe(session: EventTarget, space: XRSpace, format: ReflectionFormat): EmulatedLightProbe {
  const probe = new EmulatedLightProbe(space);
  states.set(probe, { session, format, changed: true });
  return probe;
}

export function probeState(probe: EmulatedLightProbe): ProbeState | undefined {
  return states.get(probe);
}
