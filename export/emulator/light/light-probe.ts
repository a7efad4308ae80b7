import type { XRSpace } from 'iwer';
import type { SaidLight } from './session-light.ts';

export type ReflectionFormat = 'srgba8' | 'rgba16f';

/** WebXR Lighting Estimation §2.1. */
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

/** WebXR Lighting Estimation §2.3; in the probe's space, which is turned as the world is. */
export class EmulatedLightEstimate {
  readonly sphericalHarmonicsCoefficients: Float32Array;
  readonly primaryLightDirection: DOMPointReadOnly;
  readonly primaryLightIntensity: DOMPointReadOnly;

  /** Where the device finds no direction or intensity: straight from above, and none. */
  constructor({ sphericalHarmonics, directionWorld, intensity }: SaidLight) {
    const [x, y, z] = directionWorld ?? [0, 1, 0];
    const [r, g, b] = intensity ?? [0, 0, 0];
    this.sphericalHarmonicsCoefficients = sphericalHarmonics;
    this.primaryLightDirection = new DOMPointReadOnly(x, y, z, 0);
    this.primaryLightIntensity = new DOMPointReadOnly(r, g, b, 1);
  }
}

/** What a probe was asked for and by whom; kept apart, because pages see the probe itself. */
export interface ProbeState {
  readonly session: EventTarget;
  readonly format: ReflectionFormat;
  /** The cube map is there, and the page has not been told yet. */
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
