import type { DepthFrame } from '../../kit/physics.ts';
import type { DepthImage } from '../../kit/session.ts';

/** Texels of wider depth images are skipped: at 4 m, 160 texels over 60° are 3 cm apart, less than the edge of a voxel. */
const MAX_WIDTH_PX = 160;

/** Converts depth images to depth frames, in buffers that are reused in turn. */
export interface DepthFrames {
  /**
   * Converts a depth image for the voxel grid: skips texels and computes the rays of the others. The frame is valid until as many others
   * have been written as there are buffers.
   *
   * @param spent Arrays that may be used again, because a worker has taken those of former frames. It removes what it takes.
   * @returns Null for a projection or a UV matrix without inverse.
   */
  write(image: DepthImage, deltaS: number, spent: Float32Array<ArrayBuffer>[]): DepthFrame | null;
}

interface Slot {
  meters: Float32Array<ArrayBuffer>;
  widthPx: number;
  heightPx: number;
  readonly worldFromDepth: Float64Array;
  readonly rayFromTexel: Float64Array;
  deltaS: number;
}

// Filled and read within one call: the rays of three texels.
const rays = new Float64Array(6);

export function createDepthFrames(count: number): DepthFrames {
  const slots = Array.from(
    { length: count },
    (): Slot => ({
      meters: new Float32Array(0),
      widthPx: 0,
      heightPx: 0,
      worldFromDepth: new Float64Array(16),
      rayFromTexel: new Float64Array(6),
      deltaS: 0,
    }),
  );
  let next = 0;
  return {
    write: (image, deltaS, spent) => {
      const slot = slots[next];
      const { meters, widthPx, heightPx, worldFromView } = image;
      const stride = Math.max(1, Math.ceil(widthPx / MAX_WIDTH_PX));
      if (!slot || !writeRays(image, stride, slot.rayFromTexel)) return null;
      next = (next + 1) % count;
      const width = Math.floor(widthPx / stride);
      const height = Math.floor(heightPx / stride);
      const length = width * height;
      while (slot.meters.length !== length) slot.meters = spent.pop() ?? new Float32Array(length);
      for (let j = 0; j < height; j++)
        for (let i = 0; i < width; i++) slot.meters[j * width + i] = meters[j * stride * widthPx + i * stride] ?? 0;
      slot.widthPx = width;
      slot.heightPx = height;
      slot.worldFromDepth.set(worldFromView);
      slot.deltaS = deltaS;
      return slot;
    },
  };
}

/** Writes the affine map from texels to rays. Returns false if there is none. */
function writeRays({ widthPx, heightPx, uvFromViewUv: u, clipFromView: c }: DepthImage, stride: number, out: Float64Array): boolean {
  const [a, b, d, e, s, t] = [u[0] ?? 0, u[3] ?? 0, u[1] ?? 0, u[4] ?? 0, u[6] ?? 0, u[7] ?? 0];
  const [cx, cy] = [c[0] ?? 0, c[5] ?? 0];
  const determinant = a * e - b * d;
  if (!(Math.abs(determinant) > 1e-9 && cx > 0 && cy > 0)) return false;
  // The texels (0, 0), (1, 0) and (0, 1).
  for (let k = 0; k < 3; k++) {
    const p = ((k === 1 ? stride : 0) + 0.5) / widthPx - s;
    const q = ((k === 2 ? stride : 0) + 0.5) / heightPx - t;
    rays[2 * k] = ((2 * (e * p - b * q)) / determinant - 1 + (c[8] ?? 0)) / cx;
    rays[2 * k + 1] = ((2 * (a * q - d * p)) / determinant - 1 + (c[9] ?? 0)) / cy;
  }
  const [x0, y0, x1, y1, x2, y2] = [rays[0] ?? 0, rays[1] ?? 0, rays[2] ?? 0, rays[3] ?? 0, rays[4] ?? 0, rays[5] ?? 0];
  out[0] = x1 - x0;
  out[1] = x2 - x0;
  out[2] = x0;
  out[3] = y1 - y0;
  out[4] = y2 - y0;
  out[5] = y0;
  return true;
}
