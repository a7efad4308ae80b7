/**
 * A place on the ellipsoid WGS 84, which satellite navigation uses, and its conversion to a local frame of east, north and up (NGA Standard
 * 0036, §4). Angles are in degrees, as browsers give them.
 */
export interface GeoPlace {
  latitudeDeg: number;
  longitudeDeg: number;
  /** Height above the ellipsoid, meters. */
  altitudeM: number;
}

/** An offset from the origin of a local frame, in meters to the east, to the north and up. */
export interface EastNorthUp {
  eastM: number;
  northM: number;
  upM: number;
}

const SEMI_MAJOR_M = 6_378_137;
const FLATTENING = 1 / 298.257_223_563;
const ECCENTRICITY_2 = FLATTENING * (2 - FLATTENING);

// Filled and read within one call.
const scratchOrigin = new Float64Array(3);
const scratchPlace = new Float64Array(3);

/** Writes the earth-centered, earth-fixed coordinates of a place, meters: x points to latitude 0°, longitude 0°; z to the north pole. */
function setEarthFixed(out: Float64Array, { latitudeDeg, longitudeDeg, altitudeM }: Readonly<GeoPlace>): void {
  const [latitude, longitude] = [radians(latitudeDeg), radians(longitudeDeg)];
  const sine = Math.sin(latitude);
  const normalM = SEMI_MAJOR_M / Math.sqrt(1 - ECCENTRICITY_2 * sine * sine);
  const level = (normalM + altitudeM) * Math.cos(latitude);
  out[0] = level * Math.cos(longitude);
  out[1] = level * Math.sin(longitude);
  out[2] = (normalM * (1 - ECCENTRICITY_2) + altitudeM) * sine;
}

/**
 * Writes the offset of a place from an origin, in the plane that touches the ellipsoid at the origin.
 *
 * @example
 * setEastNorthUp(offset, here, target);
 */
export function setEastNorthUp(out: EastNorthUp, origin: Readonly<GeoPlace>, place: Readonly<GeoPlace>): void {
  setEarthFixed(scratchOrigin, origin);
  setEarthFixed(scratchPlace, place);
  const offset = (i: number): number => (scratchPlace[i] ?? 0) - (scratchOrigin[i] ?? 0);
  const [x, y, z] = [offset(0), offset(1), offset(2)];
  const [latitude, longitude] = [radians(origin.latitudeDeg), radians(origin.longitudeDeg)];
  const outwards = x * Math.cos(longitude) + y * Math.sin(longitude);
  out.eastM = y * Math.cos(longitude) - x * Math.sin(longitude);
  out.northM = z * Math.cos(latitude) - outwards * Math.sin(latitude);
  out.upM = z * Math.sin(latitude) + outwards * Math.cos(latitude);
}

/**
 * Writes the place at an offset from an origin: the inverse of `setEastNorthUp`, exact to a tenth of a millimeter within 100 km.
 *
 * @example
 * setGeoPlace(place, origin, { eastM: 10, northM: 0, upM: 0 });
 */
export function setGeoPlace(out: GeoPlace, origin: Readonly<GeoPlace>, offset: Readonly<EastNorthUp>): void {
  const found = { ...origin };
  const reached: EastNorthUp = { eastM: 0, northM: 0, upM: 0 };
  // Each step leaves a difference of the second order.
  for (let i = 0; i < 6; i++) {
    setEastNorthUp(reached, origin, found);
    const latitude = radians(found.latitudeDeg);
    found.latitudeDeg += degrees((offset.northM - reached.northM) / SEMI_MAJOR_M);
    found.longitudeDeg += degrees((offset.eastM - reached.eastM) / (SEMI_MAJOR_M * Math.max(Math.cos(latitude), 1e-6)));
    found.altitudeM += offset.upM - reached.upM;
  }
  Object.assign(out, found);
}

function radians(deg: number): number {
  return (deg * Math.PI) / 180;
}

function degrees(rad: number): number {
  return (rad * 180) / Math.PI;
}
