/** A light of all sides and a strongest one, as numbers to come near to. */
export interface RoomLight {
  /** 9 coefficients × RGB, as `LightEstimate` has them. */
  readonly sphericalHarmonics: Float32Array;
  /** Unit vector in world space, from the scene towards the light. */
  readonly directionWorld: Float32Array;
  /** Linear-sRGB irradiance on a surface that faces the light. */
  readonly irradiance: Float32Array;
}

export function createRoomLight(): RoomLight {
  return { sphericalHarmonics: new Float32Array(27), directionWorld: Float32Array.of(0, 1, 0), irradiance: new Float32Array(3) };
}

/** Linear mean of a picture of a bright room indoors: what stands in where no camera shows one. */
export const DEFAULT_MEAN: Readonly<Float32Array> = Float32Array.of(0.35, 0.35, 0.35);

/** What a room sends back of the light in it, about: furnished rooms are built for a half (EN 12464-1 asks for 0.7 of ceilings, 0.2 of floors). */
const ROOM_REFLECTANCE = 0.5;
/** Of that light, so much comes from the strongest lamp: enough for a shadow that can be seen, as indoors. */
const PRIMARY_PART = 0.4;
/** From above, a little from the right and from behind the viewer, where lamps and the photographer's window are. */
const DIRECTION: readonly [number, number, number] = [0.36, 0.8, 0.48];
/** How much more light comes from straight above than from the sides, as a part of the mean: ceilings are brighter than floors. */
const FROM_ABOVE = 0.3;

// Constants of the basis: Ramamoorthi and Hanrahan 2001, eq. 3.
const Y00 = 0.282094791773878;
const Y1 = 0.488602511902919;

/**
 * Light that would make a room look as bright as its picture's mean, which says nothing of where it comes from. Radiance that
 * leaves a matt room is its reflectance times the irradiance / π; the mean of the picture stands for that radiance.
 */
export function guessLight(into: RoomLight, meanLinear: Readonly<Float32Array>): void {
  into.directionWorld.set(DIRECTION);
  into.sphericalHarmonics.fill(0);
  for (let c = 0; c < 3; c++) {
    const whole = (meanLinear[c] ?? 0) / ROOM_REFLECTANCE;
    const around = whole * (1 - PRIMARY_PART);
    // Constant radiance L is L / Y00 of the first function; L y is √(4π / 3) L of the second.
    into.sphericalHarmonics[c] = around / Y00;
    into.sphericalHarmonics[3 + c] = around * FROM_ABOVE * ((4 * Math.PI) / 3) * Y1;
    into.irradiance[c] = whole * PRIMARY_PART * Math.PI;
  }
}
