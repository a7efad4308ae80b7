import type { Eye } from '../display/eye.ts';
import type { RoomView } from '../display/room-view.ts';
import type { DepthConfiguration } from '../features.ts';
import type { DepthOptions } from '../options.ts';
import { createDepthCamera } from './depth-camera.ts';
import { affineToMatrix, depthUvFromViewUv } from './depth-transform.ts';

/** Depth sensing as one session was granted it. */
export interface SessionDepth extends DepthConfiguration {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 4×4. */
  readonly bufferFromView: Float32Array;
  readonly gpuValues: 'metres' | 'window';
  /** Metres, row-major from the top; the same array every time. */
  measure(eye: Eye): Float32Array;
  dispose(): void;
}

export function createSessionDepth(view: RoomView, granted: DepthConfiguration, options: Required<DepthOptions>): SessionDepth {
  const [widthPx, heightPx] = options.sizePx;
  const map = depthUvFromViewUv(options.transform);
  const camera = createDepthCamera(view, widthPx, heightPx, map);
  return {
    ...granted,
    widthPx,
    heightPx,
    bufferFromView: affineToMatrix(map),
    gpuValues: options.gpuValues,
    measure: camera.measure,
    dispose: camera.dispose,
  };
}
