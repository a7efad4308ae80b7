/** The light of a room as an ambient and a directional light. */
export interface RoomLight {
  /** The ambient light: 9 coefficients × RGB, as in `LightEstimate`. */
  readonly sphericalHarmonics: Float32Array;
  /** Direction of the directional light: unit vector in world space, from the scene towards the light. */
  readonly directionWorld: Float32Array;
  /** Linear-sRGB irradiance on a surface that faces the directional light. */
  readonly irradiance: Float32Array;
}

export function createRoomLight(): RoomLight {
  return { sphericalHarmonics: new Float32Array(27), directionWorld: Float32Array.of(0, 1, 0), irradiance: new Float32Array(3) };
}

/** The mean that is used without a camera image: the linear mean of an image of a bright room. */
export const DEFAULT_MEAN: Readonly<Float32Array> = Float32Array.of(0.35, 0.35, 0.35);

/** Mean reflectance of a furnished room (EN 12464-1 recommends 0.7 for ceilings and 0.2 for floors). */
const ROOM_REFLECTANCE = 0.5;
/** The fraction of the light that is directional: enough for a visible shadow, as indoors. */
const PRIMARY_PART = 0.4;
/** The assumed direction of the light: from above, slightly from the right and from behind the viewer. */
const DIRECTION: readonly [number, number, number] = [0.36, 0.8, 0.48];
/** The additional light from above, as a fraction of the mean: ceilings are brighter than floors. */
const FROM_ABOVE = 0.3;

// Constants of the spherical harmonics: Ramamoorthi and Hanrahan 2001, eq. 3.
const Y00 = 0.282094791773878;
const Y1 = 0.488602511902919;

/**
 * Estimates the light of a room from the mean of its image. The mean contains no direction, so the direction is assumed. The radiance
 * of a matte room is its reflectance times the irradiance / π; the mean of the image is used as this radiance.
 */
export function guessLight(into: RoomLight, meanLinear: Readonly<Float32Array>): void {
  into.directionWorld.set(DIRECTION);
  into.sphericalHarmonics.fill(0);
  for (let c = 0; c < 3; c++) {
    const whole = (meanLinear[c] ?? 0) / ROOM_REFLECTANCE;
    const around = whole * (1 - PRIMARY_PART);
    // A constant radiance L has the coefficient L / Y00; L · y has the coefficient √(4π / 3) L of the linear function.
    into.sphericalHarmonics[c] = around / Y00;
    into.sphericalHarmonics[3 + c] = around * FROM_ABOVE * ((4 * Math.PI) / 3) * Y1;
    into.irradiance[c] = whole * PRIMARY_PART * Math.PI;
  }
}
