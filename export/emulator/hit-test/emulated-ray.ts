type PointInit = { readonly x?: number; readonly y?: number; readonly z?: number; readonly w?: number };

/** `XRRay` of WebXR Hit Test §5.1. iwer's implementation inverts `matrix` and rejects directions without `w`. */
export class EmulatedRay {
  readonly origin: DOMPointReadOnly;
  readonly direction: DOMPointReadOnly;
  #matrix: Float32Array | null = null;

  constructor(originOrTransform: PointInit | { readonly matrix: Float32Array } = {}, direction: PointInit = { z: -1 }) {
    if ('matrix' in originOrTransform) {
      const m = originOrTransform.matrix;
      this.origin = new DOMPointReadOnly(m[12], m[13], m[14], 1);
      this.direction = unit(-(m[8] ?? 0), -(m[9] ?? 0), -(m[10] ?? 0));
      return;
    }
    const { x = 0, y = 0, z = 0, w = 1 } = originOrTransform;
    if (w !== 1) throw new TypeError('The origin of a ray must have w = 1.');
    if ((direction.w ?? 0) !== 0) throw new TypeError('The direction of a ray must have w = 0.');
    this.origin = new DOMPointReadOnly(x, y, z, 1);
    this.direction = unit(direction.x ?? 0, direction.y ?? 0, direction.z ?? 0);
  }

  /** Rigid transform that moves the ray from the origin along −z to this ray, by the smallest rotation. */
  get matrix(): Float32Array {
    this.#matrix ??= rayMatrix(this.origin, this.direction);
    return this.#matrix;
  }
}

/** Rodrigues' formula for the rotation from −z to `d` about (−z) × d. */
function rayMatrix(o: DOMPointReadOnly, d: DOMPointReadOnly): Float32Array {
  const cos = -d.z;
  // For +z every half turn is smallest; WebXR Hit Test §5.1 takes the one about x.
  if (cos < -0.999999) return new Float32Array([1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, o.x, o.y, o.z, 1]);
  const [ax, ay] = [d.y, -d.x];
  const k = 1 / (1 + cos);
  return new Float32Array([
    cos + ax * ax * k,
    ax * ay * k,
    -ay,
    0,
    ax * ay * k,
    cos + ay * ay * k,
    ax,
    0,
    ay,
    -ax,
    cos,
    0,
    o.x,
    o.y,
    o.z,
    1,
  ]);
}

function unit(x: number, y: number, z: number): DOMPointReadOnly {
  const length = Math.hypot(x, y, z);
  if (length === 0) throw new TypeError('The direction of a ray must not have length 0.');
  return new DOMPointReadOnly(x / length, y / length, z / length, 0);
}
