import { parentPort, workerData } from 'node:worker_threads';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import type { LampOptions } from '../../../nodes/kit/panorama/lamp-options.ts';
import { decodeInNode } from './decode-in-node.ts';

export interface LampWork {
  readonly bytes: Uint8Array;
  readonly options: readonly LampOptions[];
}

const { bytes, options } = workerData as LampWork;
const pixels = decodeInNode(bytes);
parentPort?.postMessage(pixels && options.map((one) => findLampsAtOnce(pixels, one)));
