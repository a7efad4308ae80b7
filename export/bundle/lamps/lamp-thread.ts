import { parentPort, workerData } from 'node:worker_threads';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import { halvesWithAlpha } from '../../../nodes/kit/panorama/half-floats.ts';
import type { LampOptions } from '../../../nodes/kit/panorama/lamp-options.ts';
import { mergeExposures } from '../../../nodes/kit/panorama/merge-exposures.ts';
import { type PanoramaPixels, runWhole } from '../../../nodes/kit/panorama/pixels.ts';
import { decodeInNode } from './decode-in-node.ts';

export interface LampWork {
  /** One panorama, or the shots of one. */
  readonly files: readonly Uint8Array[];
  /** Exposure difference of neighboring shots in stops; 0 to measure it. */
  readonly stopsApart: number;
  readonly options: readonly LampOptions[];
}

const { files, stopsApart, options } = workerData as LampWork;
const pixels = merged(files.map(decodeInNode), stopsApart);
parentPort?.postMessage(pixels && options.map((one) => findLampsAtOnce(pixels, one)));

/** One panorama as it is, or shots merged to what the page searches. Null if the page must find the lamps. */
function merged(shots: readonly (PanoramaPixels | null)[], stopsApart: number): PanoramaPixels | null {
  const all = shots.filter((shot) => shot !== null);
  if (all.length < shots.length) return null;
  if (all.length === 1) return all[0] ?? null;
  const { widthPx, heightPx, data } = runWhole(mergeExposures(all, stopsApart));
  return { widthPx, heightPx, channels: 4, data: halvesWithAlpha(data) };
}
