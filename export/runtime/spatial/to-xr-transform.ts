/** @param m Column-major 4×4, rigid. */
export function toXrTransform(m: Float32Array): XRRigidTransform {
  const at = (i: number): number => m[i] ?? 0;
  // Shepperd's method: the largest of the four components first.
  const trace = at(0) + at(5) + at(10);
  let q: [number, number, number, number];
  if (trace > at(0) && trace > at(5) && trace > at(10)) q = [at(6) - at(9), at(8) - at(2), at(1) - at(4), 1 + trace];
  else if (at(0) > at(5) && at(0) > at(10)) q = [1 + at(0) - at(5) - at(10), at(1) + at(4), at(8) + at(2), at(6) - at(9)];
  else if (at(5) > at(10)) q = [at(1) + at(4), 1 + at(5) - at(0) - at(10), at(6) + at(9), at(8) - at(2)];
  else q = [at(8) + at(2), at(6) + at(9), 1 + at(10) - at(0) - at(5), at(1) - at(4)];
  const length = Math.hypot(...q);
  const [x, y, z, w] = q;
  return new XRRigidTransform({ x: at(12), y: at(13), z: at(14) }, { x: x / length, y: y / length, z: z / length, w: w / length });
}
