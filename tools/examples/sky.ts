import { writeHdr } from './write-hdr.ts';

const WIDTH_PX = 128;
const HEIGHT_PX = 64;

type Rgb = readonly [number, number, number];

const ZENITH: Rgb = [0.12, 0.2, 0.45];
const HORIZON: Rgb = [1.1, 0.55, 0.25];
const GROUND: Rgb = [0.05, 0.045, 0.04];
const SUN: Rgb = [60, 36, 16];
/** Direction of the sun, right of the center and 9° high, and its angular radius. The sun is so large that a low resolution suffices. */
const SUN_AT = { azimuthRad: 0.9, elevationRad: 0.16, radiusRad: 0.07 };

/** An evening sky as an equirectangular HDR image: a low warm sun, a glow along the horizon, dark ground. */
export function makeSky(): Uint8Array {
  const rgb: number[] = [];
  for (let y = 0; y < HEIGHT_PX; y++) {
    const elevation = Math.PI * (0.5 - (y + 0.5) / HEIGHT_PX);
    for (let x = 0; x < WIDTH_PX; x++) {
      const azimuth = 2 * Math.PI * ((x + 0.5) / WIDTH_PX - 0.5);
      rgb.push(...radiance(azimuth, elevation));
    }
  }
  return writeHdr(WIDTH_PX, HEIGHT_PX, rgb);
}

function radiance(azimuth: number, elevation: number): Rgb {
  if (elevation < 0) return GROUND;
  const away = Math.acos(
    Math.sin(elevation) * Math.sin(SUN_AT.elevationRad) +
      Math.cos(elevation) * Math.cos(SUN_AT.elevationRad) * Math.cos(azimuth - SUN_AT.azimuthRad),
  );
  if (away < SUN_AT.radiusRad) return SUN;
  const glow = Math.exp(-elevation / 0.25) * (0.35 + 0.65 * Math.exp(-away / 0.9));
  return [0, 1, 2].map((i) => (ZENITH[i] ?? 0) + ((HORIZON[i] ?? 0) - (ZENITH[i] ?? 0)) * glow) as unknown as Rgb;
}
