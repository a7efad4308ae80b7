/**
 * Orientation of a device from `deviceorientation`: rotations about its z, x and y axes in this order, starting flat with its top to the
 * north (W3C Device Orientation §4.1). Radians.
 */
export interface DeviceAngles {
  alphaRad: number;
  betaRad: number;
  gammaRad: number;
  /** Rotation of the page relative to the device: `screen.orientation.angle`. */
  screenRad: number;
}

/**
 * Writes the orientation of a device that is held upright with its screen towards the viewer: its camera looks horizontally along −z.
 *
 * @example
 * setUpright(angles); // betaRad is π / 2, the others 0
 */
export function setUpright(out: DeviceAngles): void {
  out.alphaRad = 0;
  out.betaRad = Math.PI / 2;
  out.gammaRad = 0;
  out.screenRad = 0;
}

/**
 * Writes the rotation of a camera that looks out of the device's back, column-major 4×4 without translation. World space is y up with north
 * at −z; the sensor's earth coordinates are z up with y to the north.
 *
 * @example
 * setUpright(angles);
 * setDeviceRotation(worldFromCamera, angles); // the identity
 */
export function setDeviceRotation(out: Float32Array, { alphaRad, betaRad, gammaRad, screenRad }: DeviceAngles): void {
  const sa = Math.sin(alphaRad);
  const ca = Math.cos(alphaRad);
  const sb = Math.sin(betaRad);
  const cb = Math.cos(betaRad);
  const sg = Math.sin(gammaRad);
  const cg = Math.cos(gammaRad);
  const ss = Math.sin(screenRad);
  const cs = Math.cos(screenRad);
  // Axes of the device in earth coordinates: the columns of Rz(alpha) Rx(beta) Ry(gamma).
  const xEast = ca * cg - sa * sb * sg;
  const xNorth = sa * cg + ca * sb * sg;
  const xUp = -cb * sg;
  const yEast = -sa * cb;
  const yNorth = ca * cb;
  const yUp = sb;
  const zEast = ca * sg + sa * sb * cg;
  const zNorth = sa * sg - ca * sb * cg;
  const zUp = cb * cg;
  out.fill(0);
  out[0] = cs * xEast - ss * yEast;
  out[1] = cs * xUp - ss * yUp;
  out[2] = -(cs * xNorth - ss * yNorth);
  out[4] = ss * xEast + cs * yEast;
  out[5] = ss * xUp + cs * yUp;
  out[6] = -(ss * xNorth + cs * yNorth);
  out[8] = zEast;
  out[9] = zUp;
  out[10] = -zNorth;
  out[15] = 1;
}

/**
 * Rotates a matrix in place about the vertical axis of the world.
 *
 * @example
 * turnAboutVertical(worldFromCamera, Math.PI / 2); // turned left by 90°
 */
export function turnAboutVertical(m: Float32Array, yawRad: number): void {
  const s = Math.sin(yawRad);
  const c = Math.cos(yawRad);
  for (let column = 0; column < 12; column += 4) {
    const x = m[column] ?? 0;
    const z = m[column + 2] ?? 0;
    m[column] = c * x + s * z;
    m[column + 2] = c * z - s * x;
  }
}

/**
 * The yaw by which `turnAboutVertical` makes a rotation look along −z. If the rotation looks straight up or down, the direction of the
 * device's top counts instead.
 *
 * @example
 * turnAboutVertical(worldFromCamera, yawToFront(worldFromCamera)); // now it looks along -z
 */
export function yawToFront(m: Float32Array): number {
  let x = -(m[8] ?? 0);
  let z = -(m[10] ?? 0);
  if (Math.hypot(x, z) < 0.3) {
    const sign = (m[9] ?? 0) > 0 ? 1 : -1;
    x = sign * (m[4] ?? 0);
    z = sign * (m[6] ?? 0);
  }
  return Math.atan2(x, -z);
}

/**
 * How far one rotation is turned against another about the vertical, clockwise seen from above, in (-π, π]. All axes count, so the angle
 * holds in any tilt.
 *
 * @param to, from Column-major 4×4, y up.
 *
 * @example
 * const northRad = clockwiseTurn(earthFromDevice, worldFromView); // azimuth of the -z axis of world space
 */
export function clockwiseTurn(to: ArrayLike<number>, from: ArrayLike<number>): number {
  let sine = 0;
  let cosine = 0;
  for (let axis = 0; axis < 12; axis += 4) {
    const [rightTo, aheadTo] = [to[axis] ?? 0, -(to[axis + 2] ?? 0)];
    const [rightFrom, aheadFrom] = [from[axis] ?? 0, -(from[axis + 2] ?? 0)];
    sine += rightTo * aheadFrom - aheadTo * rightFrom;
    cosine += aheadTo * aheadFrom + rightTo * rightFrom;
  }
  return Math.atan2(sine, cosine);
}

/**
 * Writes the angles of a device that has this rotation, with the page upright on it: the inverse of `setDeviceRotation`.
 *
 * @param rotation Column-major 4×4, y up, north at -z.
 *
 * @example
 * setDeviceAngles(angles, worldFromView);
 */
export function setDeviceAngles(out: DeviceAngles, rotation: ArrayLike<number>): void {
  const at = (i: number): number => rotation[i] ?? 0;
  const side = at(9) < 0 ? -1 : 1;
  const level = Math.hypot(at(1), at(9));
  out.betaRad = Math.atan2(at(5), side * level);
  out.screenRad = 0;
  if (level < 1e-6) {
    // Upright, alpha and gamma turn about the same axis.
    out.gammaRad = 0;
    out.alphaRad = Math.atan2(-at(2), at(0));
    return;
  }
  out.gammaRad = Math.atan2(-side * at(1), side * at(9));
  out.alphaRad = Math.atan2(-side * at(4), -side * at(6));
}

/**
 * The angle by which the page is rotated on the device, radians: `screen.orientation.angle`. Safari before 16.4 has only
 * `window.orientation`, which is the same angle, but -90° instead of 270°.
 *
 * @example
 * angles.screenRad = screenAngle(window);
 */
export function screenAngle(page: { readonly screen: Screen; readonly orientation?: number }): number {
  return ((page.screen.orientation?.angle ?? page.orientation ?? 0) * Math.PI) / 180;
}
