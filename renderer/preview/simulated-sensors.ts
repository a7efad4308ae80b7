import { type EmulatedSensors, installSensors, type LocationState } from '../../export/emulator/sensors/emulated-sensors.ts';
import type { Program } from '../../export/program/program.ts';
import { type DeviceAngles, setDeviceAngles } from '../../nodes/kit/device-orientation.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { type GeoPlace, setGeoPlace } from '../../nodes/kit/wgs84.ts';

/**
 * The sensors of a phone in the preview: it is tilted and turned as the view is, and its location follows the viewer's walk. Keys shake the
 * phone, turn north, and remove the location.
 */
export interface SimulatedSensors {
  /** Called before a program is played. Installs the sensors if the program needs them, else removes them. */
  follow(program: Program): void;
  beforeFrame(frame: SessionFrame): void;
  /** Whether the key drives the sensors at the moment. */
  isKey(event: KeyboardEvent): boolean;
}

const SHAKE = 'KeyX';
const LOCATION = 'KeyB';
const TURN = 'KeyJ';
const HINT = 'X: shake · B: location good, inaccurate, denied · J: turn north by 15° · the phone is held as the view';

/** The Royal Observatory in Greenwich, where the node `pose/geo` points by default; the viewer begins 20 m south of it. */
const ORIGIN: GeoPlace = { latitudeDeg: 51.477928, longitudeDeg: -0.001545, altitudeM: 47 };
const SOUTH_M = 20;
const TURN_RAD = Math.PI / 12;
const DEG_PER_RAD = 180 / Math.PI;
const LOCATIONS: readonly { readonly state: LocationState; readonly accuracyM: number }[] = [
  { state: 'granted', accuracyM: 5 },
  { state: 'granted', accuracyM: 120 },
  { state: 'denied', accuracyM: 5 },
];
const SHAKE_M_PER_S2 = 20;
const SHAKES = 4;
/** Devices give a position once a second. */
const FIX_PERIOD_S = 1;

/**
 * Creates the sensors; `follow` installs them.
 *
 * @param hint Element that shows the keys.
 */
export function createSimulatedSensors(page: Window, hint: HTMLElement): SimulatedSensors {
  let sensors: EmulatedSensors | null = null;
  let northRad = 0;
  let location = 0;
  let shakes = 0;
  let fixedS = Number.NEGATIVE_INFINITY;
  const angles: DeviceAngles = { alphaRad: 0, betaRad: 0, gammaRad: 0, screenRad: 0 };
  const last: DeviceAngles = { ...angles };
  const place: GeoPlace = { ...ORIGIN };
  hint.textContent = HINT;

  const isKey = ({ code, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean =>
    sensors !== null && [SHAKE, LOCATION, TURN].includes(code) && !ctrlKey && !metaKey && !altKey;
  page.addEventListener('keydown', (event) => {
    if (!isKey(event)) return;
    event.preventDefault();
    if (event.code === SHAKE) shakes = SHAKES;
    else if (event.code === TURN) northRad += TURN_RAD;
    else {
      location = (location + 1) % LOCATIONS.length;
      sensors?.setLocation(LOCATIONS[location]?.state ?? 'granted');
      fixedS = Number.NEGATIVE_INFINITY;
    }
  });

  function orient(worldFromView: Float32Array, deltaS: number): void {
    Object.assign(last, angles);
    setDeviceAngles(angles, worldFromView);
    angles.alphaRad -= northRad;
    sensors?.orient((((angles.alphaRad * DEG_PER_RAD) % 360) + 360) % 360, angles.betaRad * DEG_PER_RAD, angles.gammaRad * DEG_PER_RAD);
    const up = [worldFromView[1] ?? 0, worldFromView[5] ?? 0, worldFromView[9] ?? 0];
    // Left and right in turn.
    const push = shakes > 0 ? (shakes % 2 === 0 ? SHAKE_M_PER_S2 : -SHAKE_M_PER_S2) : 0;
    if (shakes > 0) shakes--;
    const perS = deltaS > 0 ? 1 / deltaS : 0;
    const about = (to: number, from: number): number => Math.atan2(Math.sin(to - from), Math.cos(to - from)) * perS;
    // For an upright device: about x it leans, about y it turns.
    sensors?.move([push, 0, 0], [about(angles.betaRad, last.betaRad), about(angles.alphaRad, last.alphaRad), 0], up);
  }
  function locate({ timeS }: SessionFrame, worldFromView: Float32Array): void {
    if (timeS - fixedS < FIX_PERIOD_S && timeS >= fixedS) return;
    fixedS = timeS;
    const [rightM, aheadM] = [worldFromView[12] ?? 0, -(worldFromView[14] ?? 0)];
    const [sine, cosine] = [Math.sin(northRad), Math.cos(northRad)];
    const eastM = rightM * cosine + aheadM * sine;
    const northM = aheadM * cosine - rightM * sine - SOUTH_M;
    setGeoPlace(place, ORIGIN, { eastM, northM, upM: worldFromView[13] ?? 0 });
    sensors?.setPlace(place, LOCATIONS[location]?.accuracyM ?? 5);
  }

  return {
    follow: ({ needs }) => {
      const isNeeded = needs.some(({ capability }) => capability === 'motion' || capability === 'location');
      if (isNeeded === (sensors !== null)) return;
      hint.hidden = !isNeeded;
      if (isNeeded) {
        sensors = installSensors();
      } else {
        sensors?.uninstall();
        sensors = null;
      }
    },
    beforeFrame: (frame) => {
      const view = frame.viewCount > 0 ? frame.views[0] : undefined;
      if (!sensors || !view) return;
      orient(view.worldFromView, frame.deltaS);
      locate(frame, view.worldFromView);
    },
    isKey,
  };
}
