import { type DeviceAngles, screenAngle, setUpright } from '../../../../nodes/kit/device-orientation.ts';

/** The members of `Window` that the sensor uses, so that tests can supply them. */
export type OrientationWindow = Pick<Window, 'addEventListener' | 'removeEventListener' | 'screen'> & {
  readonly DeviceOrientationEvent?: unknown;
};

export interface OrientationSensor {
  /** The newest reading; before the first, those of a device held upright. */
  readonly angles: Readonly<DeviceAngles>;
  /** Whether there was a reading. Computers without a sensor report nulls or nothing. */
  readonly present: boolean;
  dispose(): void;
}

/**
 * Requests permission for the orientation sensor where the browser requires it (Safari on iOS). Call it from a click handler. Never
 * rejects.
 *
 * @returns `absent` if the browser has no sensor API; `granted` also if it requires no permission.
 */
export async function requestOrientationPermission(window: OrientationWindow): Promise<'granted' | 'denied' | 'absent'> {
  const events = window.DeviceOrientationEvent as { requestPermission?: () => Promise<string> } | undefined;
  if (!events) return 'absent';
  if (typeof events.requestPermission !== 'function') return 'granted';
  // Rejects if it was not called from a click handler.
  const answer = await events.requestPermission().catch(() => 'denied');
  return answer === 'granted' ? 'granted' : 'denied';
}

export function listenForOrientation(window: OrientationWindow): OrientationSensor {
  const angles: DeviceAngles = { alphaRad: 0, betaRad: 0, gammaRad: 0, screenRad: 0 };
  setUpright(angles);
  let present = false;
  const turned = (event: DeviceOrientationEvent): void => {
    if (event.alpha === null || event.beta === null || event.gamma === null) return;
    present = true;
    angles.alphaRad = radians(event.alpha);
    angles.betaRad = radians(event.beta);
    angles.gammaRad = radians(event.gamma);
    angles.screenRad = screenAngle(window);
  };
  // A device at rest sends no readings, but the page may rotate.
  const pageTurned = (): void => {
    if (present) angles.screenRad = screenAngle(window);
  };
  window.addEventListener('deviceorientation', turned);
  window.screen.orientation?.addEventListener('change', pageTurned);
  return {
    angles,
    get present() {
      return present;
    },
    dispose: () => {
      window.removeEventListener('deviceorientation', turned);
      window.screen.orientation?.removeEventListener('change', pageTurned);
    },
  };
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}
