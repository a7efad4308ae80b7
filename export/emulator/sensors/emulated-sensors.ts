import type { GeoPlace } from '../../../nodes/kit/wgs84.ts';

/** State of the motion and orientation sensors: the visitor allows them, the visitor denies them, or the device has none. */
export type SensorState = 'granted' | 'denied' | 'absent';
export type LocationState = 'granted' | 'denied' | 'unavailable' | 'timeout';

/** Controls of the emulated sensors of a phone: motion, orientation with compass, location. */
export interface EmulatedSensors {
  /**
   * Dispatches a `devicemotion` event with values along the axes of the device: x right, y to the top, z out of the screen.
   *
   * @param acceleration Without gravity, m/s².
   * @param rotationRate Radians per second.
   * @param up Away from the ground, a unit vector.
   */
  move(acceleration: readonly number[], rotationRate: readonly number[], up: readonly number[]): void;
  /** Dispatches `deviceorientation` events with these angles, in degrees relative to magnetic north. */
  orient(alphaDeg: number, betaDeg: number, gammaDeg: number): void;
  /**
   * Moves the device to a place and reports it to the page. `accuracyM` is the reported accuracy: 95 % of positions are closer than that.
   */
  setPlace(place: Readonly<GeoPlace>, accuracyM: number): void;
  /** Sets how requests for the location are answered from now on. */
  setLocation(state: LocationState): void;
  /** Sets whether sensor events are dispatched, which is also the answer to a page that requests motion sensors. */
  setSensors(state: SensorState): void;
  /** Number of active `watchPosition` calls, for leak tests. */
  readonly watches: number;
  uninstall(): void;
}

export interface SensorOptions {
  /**
   * Whether to behave like Safari on iOS: pages must request permission, accelerations have the opposite sign, and orientation events have
   * a compass heading.
   */
  readonly safari?: boolean;
}

interface Watch {
  readonly onFix: PositionCallback;
  readonly onError: PositionErrorCallback | null;
}

const ERROR_CODES = { denied: 1, unavailable: 2, timeout: 3 } as const;
const DEG_PER_RAD = 180 / Math.PI;
const G_M_PER_S2 = 9.81;

/**
 * Installs emulated sensors in this page, until `uninstall`: `navigator.geolocation`, and events of motion and orientation.
 *
 * @example
 * const sensors = installSensors();
 * sensors.setPlace({ latitudeDeg: 51.4779, longitudeDeg: 0, altitudeM: 45 }, 5);
 */
export function installSensors({ safari = false }: SensorOptions = {}): EmulatedSensors {
  const watches = new Map<number, Watch>();
  let next = 1;
  let state: LocationState = 'granted';
  let sensors: SensorState = 'granted';
  let place: Readonly<GeoPlace> | null = null;
  let accuracyM = 5;
  /** Number of positions given to the page so far; their timestamps are one second apart. */
  let fixes = 0;

  const tell = ({ onFix, onError }: Watch): void => {
    if (state !== 'granted') {
      onError?.({ code: ERROR_CODES[state], message: state, PERMISSION_DENIED: 1, POSITION_UNAVAILABLE: 2, TIMEOUT: 3 });
      return;
    }
    if (!place) return;
    const { latitudeDeg: latitude, longitudeDeg: longitude, altitudeM: altitude } = place;
    const none = { altitudeAccuracy: 2 * accuracyM, heading: null, speed: null };
    const coords = { latitude, longitude, altitude, accuracy: accuracyM, ...none };
    onFix({ coords: { ...coords, toJSON: () => coords }, timestamp: 1000 * ++fixes, toJSON: () => coords });
  };
  const tellAll = (): void => {
    for (const watch of [...watches.values()]) tell(watch);
  };
  const watchPosition = (onFix: PositionCallback, onError: PositionErrorCallback | null = null): number => {
    const watch = { onFix, onError };
    const id = next++;
    watches.set(id, watch);
    // As in browsers, never within the call.
    queueMicrotask(() => {
      if (watches.has(id)) tell(watch);
    });
    return id;
  };
  const geolocation = {
    watchPosition,
    clearWatch: (id: number) => void watches.delete(id),
    getCurrentPosition: (onFix: PositionCallback, onError: PositionErrorCallback | null = null) =>
      queueMicrotask(() => tell({ onFix, onError })),
  };
  const before = Object.getOwnPropertyDescriptor(navigator, 'geolocation');
  Object.defineProperty(navigator, 'geolocation', { configurable: true, value: geolocation });
  const restoreEvents = safari ? askAsSafari(() => sensors) : () => {};
  const dispatch = (type: string, members: object): void => {
    if (sensors === 'granted') window.dispatchEvent(Object.assign(new Event(type), members));
  };

  return {
    move: (acceleration, rotationRate, up) => {
      const sign = safari ? -1 : 1;
      const at = (list: readonly number[], i: number, factor: number): number => factor * (list[i] ?? 0);
      const axes = (list: readonly number[]) => ({ x: at(list, 0, sign), y: at(list, 1, sign), z: at(list, 2, sign) });
      dispatch('devicemotion', {
        acceleration: axes(acceleration),
        accelerationIncludingGravity: axes(acceleration.map((a, i) => a + G_M_PER_S2 * (up[i] ?? 0))),
        rotationRate: {
          alpha: at(rotationRate, 0, DEG_PER_RAD),
          beta: at(rotationRate, 1, DEG_PER_RAD),
          gamma: at(rotationRate, 2, DEG_PER_RAD),
        },
        interval: 16,
      });
    },
    orient: (alpha, beta, gamma) => {
      if (!safari) {
        dispatch('deviceorientation', { alpha, beta, gamma, absolute: false });
        dispatch('deviceorientationabsolute', { alpha, beta, gamma, absolute: true });
        return;
      }
      // In Safari, alpha is relative to an arbitrary direction, here at 123°.
      const compass = { webkitCompassHeading: (((360 - alpha) % 360) + 360) % 360, webkitCompassAccuracy: 10 };
      dispatch('deviceorientation', { alpha: alpha + 123, beta, gamma, absolute: false, ...compass });
    },
    setPlace: (to, withinM) => {
      place = { ...to };
      accuracyM = withinM;
      tellAll();
    },
    setLocation: (to) => {
      state = to;
      tellAll();
    },
    setSensors: (to) => {
      sensors = to;
    },
    get watches() {
      return watches.size;
    },
    uninstall: () => {
      watches.clear();
      restoreEvents();
      if (before) Object.defineProperty(navigator, 'geolocation', before);
      else Reflect.deleteProperty(navigator, 'geolocation');
    },
  };
}

/** Replaces the classes of sensor events by objects with Safari's `requestPermission`. Returns a function that restores them. */
function askAsSafari(answer: () => SensorState): () => void {
  const page = window as unknown as Record<string, unknown>;
  const names = ['DeviceMotionEvent', 'DeviceOrientationEvent'] as const;
  const before = names.map((name) => Object.getOwnPropertyDescriptor(page, name));
  for (const name of names) {
    Object.defineProperty(page, name, { configurable: true, value: { requestPermission: async () => answer() } });
  }
  return () => {
    names.forEach((name, i) => {
      const descriptor = before[i];
      if (descriptor) Object.defineProperty(page, name, descriptor);
      else Reflect.deleteProperty(page, name);
    });
  };
}
