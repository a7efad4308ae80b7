import { describe, expect, test } from '@jest/globals';
import { createRandom } from '../../export/runtime/random.ts';
import { type GeoPlace, setEastNorthUp, setGeoPlace } from './wgs84.ts';

const dms = (degrees: number, minutes: number, seconds: number) => Math.sign(degrees) * (Math.abs(degrees) + minutes / 60 + seconds / 3600);
const place = (latitudeDeg: number, longitudeDeg: number, altitudeM = 0): GeoPlace => ({ latitudeDeg, longitudeDeg, altitudeM });

function offset(from: GeoPlace, to: GeoPlace) {
  const out = { eastM: 0, northM: 0, upM: 0 };
  setEastNorthUp(out, from, to);
  return out;
}

describe('a local frame on WGS 84', () => {
  test('agrees with the surveyors’ line from Flinders Peak to Buninyong', () => {
    // Geocentric Datum of Australia Technical Manual, §4.1: 54,972.271 m along the ellipsoid, at 306° 52′ 05.37″.
    const flinders = place(dms(-37, 57, 3.7203), dms(144, 25, 29.5244));
    const buninyong = place(dms(-37, 39, 10.1561), dms(143, 55, 35.3839));
    const { eastM, northM, upM } = offset(flinders, buninyong);
    // The chord is shorter than the arc by s³ / 24 R²: 0.17 m.
    const arcM = 54_972.271;
    expect(Math.hypot(eastM, northM, upM)).toBeCloseTo(arcM - arcM ** 3 / (24 * 6_371_000 ** 2), 1);
    expect(((Math.atan2(eastM, northM) * 180) / Math.PI + 360) % 360).toBeCloseTo(dms(306, 52, 5.37), 2);
    // The earth curves away by s² / 2R.
    expect(upM).toBeCloseTo(-(arcM ** 2) / (2 * 6_371_000), -1);
  });

  test.each([
    // Meters of a second of arc by the radii of curvature, π/648000 · M and π/648000 · N cos φ.
    ['at the equator', 0, 30.715, 30.9221],
    ['at 45°', 45, 30.869, 21.9021],
    ['at 60°', 60, 30.9463, 15.5],
  ])('has the meters of a second of arc %s', (_where, latitudeDeg, northM, eastM) => {
    const second = 1 / 3600;
    const from = place(latitudeDeg, 10);
    expect(offset(from, place(latitudeDeg + second, 10)).northM).toBeCloseTo(northM, 2);
    expect(offset(from, place(latitudeDeg, 10 + second)).eastM).toBeCloseTo(eastM, 2);
    expect(offset(from, { ...from, altitudeM: 12 })).toEqual({
      eastM: expect.closeTo(0, 6),
      northM: expect.closeTo(0, 6),
      upM: expect.closeTo(12, 6),
    });
  });

  test('goes there and back to less than a millimeter, also over the date line', () => {
    const random = createRandom(1, 'wgs84');
    for (let i = 0; i < 100; i++) {
      const origin = place(random.next() * 160 - 80, i % 2 ? 179.9999 : random.next() * 360 - 180, random.next() * 3000);
      const to = { eastM: (random.next() - 0.5) * 4e4, northM: (random.next() - 0.5) * 4e4, upM: (random.next() - 0.5) * 200 };
      const found = place(0, 0);
      setGeoPlace(found, origin, to);
      const again = offset(origin, found);
      expect(Math.hypot(again.eastM - to.eastM, again.northM - to.northM, again.upM - to.upM)).toBeLessThan(1e-3);
    }
  });
});
