/** Values of the real spherical harmonics of bands 0 to 2 in a direction, function by function (WebXR Lighting Estimation §3.2). */
export function harmonicsBasis(x: number, y: number, z: number): number[] {
  return [
    0.282095,
    0.488603 * y,
    0.488603 * z,
    0.488603 * x,
    1.092548 * x * y,
    1.092548 * y * z,
    0.315392 * (3 * z * z - 1),
    1.092548 * x * z,
    0.546274 * (x * x - y * y),
  ];
}
