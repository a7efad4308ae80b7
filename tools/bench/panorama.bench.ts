import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import process from 'node:process';
import { findLamps, searchWhole } from '../../nodes/kit/panorama/find-lamps.ts';
import type { LampOptions } from '../../nodes/kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../nodes/kit/panorama/pixels.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';

const SIZES = [
  [1024, 512],
  [4096, 2048],
] as const;
const METHODS: readonly Pick<LampOptions, 'method' | 'iterations'>[] = [
  { method: 'paper', iterations: 1 },
  { method: 'solid-angle', iterations: 1 },
];

const SAMPLES = 15;

/**
 * CPU time to find the lamps of a decoded panorama, without its decoding, beside the steps of `paper` by OpenCV on one thread, where
 * `python3` has the package `opencv-python-headless`.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const hasOpenCv = spawnSync('python3', ['-c', 'import cv2']).status === 0;
  if (!hasOpenCv) console.error('OpenCV is not measured: python3 has no package opencv-python-headless.');
  return SIZES.flatMap(([widthPx, heightPx]) => {
    const pixels = room(widthPx, heightPx);
    const ours = METHODS.map((method): Bench => {
      const options: LampOptions = { lamps: 3, intensities: 'ranks', clippedShare: 0.5, ...method };
      return {
        name: `lamps of a panorama, ${method.method}, ${widthPx} × ${heightPx}`,
        unit: 'ms',
        samples: SAMPLES,
        sample: () => cpuMs(() => searchWhole(findLamps(pixels, options))),
      };
    });
    return hasOpenCv ? [...ours, openCv(root, widthPx, heightPx)] : ours;
  });
}

/** The times that OpenCV takes. One process measures them all. */
function openCv(root: string, widthPx: number, heightPx: number): Bench {
  let times: number[] = [];
  return {
    name: `lamps of a panorama, paper by OpenCV, ${widthPx} × ${heightPx}`,
    unit: 'ms',
    samples: SAMPLES,
    sample: () => {
      if (times.length === 0) times = timesOfOpenCv(root, widthPx, heightPx);
      return times.pop() ?? Number.NaN;
    },
  };
}

function timesOfOpenCv(root: string, widthPx: number, heightPx: number): number[] {
  const script = join(root, 'tools', 'bench', 'opencv-lamps.py');
  const args = [widthPx, heightPx, SAMPLES + 1].map(String);
  const { status, stdout, stderr } = spawnSync('python3', [script, ...args], { encoding: 'utf8' });
  if (status !== 0) throw new Error(`OpenCV could not be measured: ${stderr}`);
  return stdout.trim().split('\n').map(Number).reverse();
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
