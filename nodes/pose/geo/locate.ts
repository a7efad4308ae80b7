import { onGestures } from '../../kit/sensor-permission.ts';
import type { GeoPlace } from '../../kit/wgs84.ts';

/** A position of the device. */
export interface GeoFix extends Readonly<GeoPlace> {
  /** Radius around the position that contains the true one in 95 % of cases, horizontal, meters (W3C Geolocation, “accuracy”). */
  readonly accuracyM: number;
  /**
   * Accuracy of the altitude, meters: half-width of the interval that contains the true altitude in 95 % of cases. Null if the device does
   * not know the altitude.
   */
  readonly altitudeAccuracyM: number | null;
}

/** Why there is no position. `timeout`: the search continues. */
export type GeoRefusal = 'denied' | 'unavailable' | 'timeout' | 'absent';

/** Time after which a search reports `timeout`, milliseconds. Satellite receivers need half a minute after a long pause. */
const TIMEOUT_MS = 30_000;

/**
 * Follows the location of the device from the visitor's first touch on, when browsers may ask for it.
 *
 * @param onAsk Called when the search begins.
 * @returns A function that stops following.
 */
export function locate(onAsk: () => void, onFix: (fix: GeoFix) => void, onRefusal: (reason: GeoRefusal) => void): () => void {
  // Undefined in some browsers without HTTPS.
  const geolocation: Geolocation | undefined = navigator.geolocation;
  if (!geolocation) {
    onRefusal('absent');
    return () => {};
  }
  let watch: number | null = null;
  let isOver = false;
  const begin = (): void => {
    if (isOver || watch !== null) return;
    stop();
    onAsk();
    watch = geolocation.watchPosition(
      ({ coords }) => {
        const { latitude, longitude, altitude, accuracy, altitudeAccuracy } = coords;
        if (!isOver && [latitude, longitude, accuracy].every(Number.isFinite)) {
          onFix({
            latitudeDeg: latitude,
            longitudeDeg: longitude,
            altitudeM: altitude ?? 0,
            accuracyM: accuracy,
            altitudeAccuracyM: altitude === null ? null : (altitudeAccuracy ?? accuracy),
          });
        }
      },
      ({ code }) => {
        // 1: permission denied, 3: timeout (W3C Geolocation, “GeolocationPositionError”).
        if (!isOver) onRefusal(code === 1 ? 'denied' : code === 3 ? 'timeout' : 'unavailable');
      },
      { enableHighAccuracy: true, timeout: TIMEOUT_MS, maximumAge: 0 },
    );
  };
  const stop = onGestures(begin);
  // The touch that started the session may have happened before.
  if (navigator.userActivation?.hasBeenActive) begin();
  return () => {
    isOver = true;
    stop();
    if (watch !== null) geolocation.clearWatch(watch);
  };
}
