import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import { PanoramaError, type RadianceHeader } from './radiance-header.ts';
import { readRadiance } from './read-radiance.ts';

/** A file to decode. Ending the worker cancels it. */
export interface RadianceTask {
  readonly as: 'halves' | 'floats';
  readonly bytes: ArrayBuffer;
  readonly header: RadianceHeader;
}

/** The pixels, or why there are none. */
export type RadianceAnswer = { readonly pixels: PanoramaPixels } | { readonly failure: string };

/** The part of a worker's global scope that is used. */
export interface RadianceScope {
  onmessage: ((event: { readonly data: RadianceTask }) => void) | null;
  postMessage(answer: RadianceAnswer, transfer: ArrayBuffer[]): void;
}

/** Decodes files in a worker: one answer for each message. `tools/gen` makes the text of the worker. */
export function serve(scope: RadianceScope): void {
  scope.onmessage = ({ data: { as, bytes, header } }) => {
    try {
      const pixels = readRadiance[as](bytes, header);
      scope.postMessage({ pixels }, [pixels.data.buffer as ArrayBuffer]);
    } catch (error) {
      const failure =
        error instanceof PanoramaError ? error.message : `it cannot be decoded here (${String(error)}). Use a smaller panorama`;
      scope.postMessage({ failure }, []);
    }
  };
}
