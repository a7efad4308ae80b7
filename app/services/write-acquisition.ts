import { encode as encodePng } from 'fast-png';
import { fillEmpty } from '../../export/captures/acquire/fill-empty.ts';
import type { Photograph } from '../../export/captures/acquire/take-photograph.ts';
import { type AcquiredCamera, type AcquiredView, transformsText } from '../../export/captures/acquire/write-transforms.ts';
import { writePfm } from '../../export/captures/depth/write-pfm.ts';
import { encodeDepth } from './encode-png.ts';

/** PFM: 32-bit floats, meters. PNG: 16 bits, millimeters, up to 65 m. */
export type DepthFormat = 'pfm' | 'png';

export interface AcquisitionFormat {
  readonly camera: AcquiredCamera;
  /** Column-major 4×4, in the order of the photographs. */
  readonly poses: readonly (readonly number[])[];
  readonly depthFormat: DepthFormat;
}

/** Writes photographs one by one, as `importCapture` reads them. */
export interface AcquisitionWriter {
  readonly views: readonly AcquiredView[];
  /** The files of the photographs that show nothing. */
  readonly empty: readonly string[];
  add(index: number, photograph: Photograph): Promise<void>;
  /** Writes the cameras of all photographs so far. */
  finish(): Promise<void>;
}

/** @param write Writes a file, by its path in the folder. */
export function createAcquisitionWriter(
  write: (path: string, bytes: Uint8Array) => Promise<void>,
  { camera, poses, depthFormat }: AcquisitionFormat,
): AcquisitionWriter {
  const views: AcquiredView[] = [];
  const empty: string[] = [];
  return {
    views,
    empty,
    add: async (index, { color, depth }) => {
      const stem = String(index).padStart(4, '0');
      const [file, depthFile] = [`images/${stem}.png`, `depth/${stem}.${depthFormat}`];
      const { widthPx: width, heightPx: height } = color;
      const data = fillEmpty(color.pixels, width, height);
      await write(file, encodePng({ width, height, data, channels: 4, depth: 8 }));
      await write(depthFile, depthFormat === 'png' ? encodeDepth(depth) : writePfm({ ...depth, values: depth.meters }));
      if (!depth.meters.some((meters) => meters > 0)) empty.push(file);
      views.push({ file, depthFile, worldFromCamera: poses[index] ?? [] });
    },
    finish: () => write('transforms.json', new TextEncoder().encode(transformsText(camera, views))),
  };
}
