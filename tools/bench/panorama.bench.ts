import process from 'node:process';
import { findLamps, searchWhole } from '../../nodes/kit/panorama/find-lamps.ts';
import type { LampOptions } from '../../nodes/kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';
import type { Bench } from './bench.ts';

const SIZES = [
  [1024, 512],
  [4096, 2048],
] as const;
const METHODS: readonly Pick<LampOptions, 'method' | 'iterations'>[] = [
  { method: 'paper', iterations: 1 },
  { method: 'solid-angle', iterations: 1 },
];

/**
 * CPU time to find the lamps of a decoded panorama, without its decoding. OpenCV 5.0.0 takes 2 ms and 27 ms for the steps of `paper` on one
 * thread of the same machine.
 */
export async function benches(): Promise<readonly Bench[]> {
  return SIZES.flatMap(([widthPx, heightPx]) => {
    const pixels = room(widthPx, heightPx);
    return METHODS.map((method): Bench => {
      const options: LampOptions = { lamps: 3, intensities: 'ranks', clippedShare: 0.5, ...method };
      return {
        name: `lamps of a panorama, ${method.method}, ${widthPx} × ${heightPx}`,
        unit: 'ms',
        samples: 15,
        sample: () => cpuMs(() => searchWhole(findLamps(pixels, options))),
      };
    });
  });
}

/** A panorama in bytes: a smooth room with a lamp and a window. */
function room(widthPx: number, heightPx: number): PanoramaPixels {
  const data = new Uint8Array(widthPx * heightPx * 3);
  for (let y = 0, i = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++, i += 3) {
      const [u, v] = [x / widthPx, y / heightPx];
      const isLamp = Math.hypot((u - 0.6) * 2, v - 0.25) < 0.03;
      const isWindow = u > 0.2 && u < 0.25 && v > 0.35 && v < 0.45;
      data.fill(isLamp ? 255 : isWindow ? 240 : 60 + 40 * Math.sin(7 * u) * Math.cos(5 * v), i, i + 3);
    }
  }
  return { widthPx, heightPx, channels: 3, data };
}

/** CPU time in milliseconds that `work` takes in this process. Depends less on the load of the machine than wall-clock time. */
function cpuMs(work: () => unknown): number {
  const before = process.cpuUsage();
  work();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}
