import { type DeviceAngles, setUpright } from './device-pose.ts';

/** What a window offers to tell how its device is turned; a test brings its own. */
export type OrientationWindow = Pick<Window, 'addEventListener' | 'removeEventListener' | 'screen'> & {
  readonly DeviceOrientationEvent?: unknown;
};

export interface OrientationSensor {
  /** The newest reading; upright until there is one. */
  readonly angles: Readonly<DeviceAngles>;
  /** Whether there was a reading: computers without the sensor give one of nulls, or none. */
  readonly present: boolean;
  dispose(): void;
}

/**
 * Asks for leave to read the sensor where that is necessary (Safari on iOS), which has to happen in a click. `absent` where the
 * browser knows nothing of it. Never rejects.
 */
export async function askForOrientation(window: OrientationWindow): Promise<'granted' | 'denied' | 'absent'> {
  const events = window.DeviceOrientationEvent as { requestPermission?: () => Promise<string> } | undefined;
  if (!events) return 'absent';
  if (typeof events.requestPermission !== 'function') return 'granted';
  // It rejects where it was not called from a click.
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
    angles.screenRad = radians(screenAngle(window));
  };
  // Held still, a device says nothing more; its page may be turned all the same.
  const pageTurned = (): void => {
    if (present) angles.screenRad = radians(screenAngle(window));
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

/** Safari before 16.4 has the older name alone, counting a turn to the right as negative, too. */
function screenAngle(window: OrientationWindow): number {
  return window.screen.orientation?.angle ?? (window as { readonly orientation?: number }).orientation ?? 0;
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}
