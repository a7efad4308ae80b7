import type { DepthFormat } from '../profiles.ts';

export interface EncodedDepth {
  /** Row-major from the top, without padding; 0 means unknown. */
  readonly data: ArrayBuffer;
  readonly rawValueToMeters: number;
}

const METERS_PER_UNIT = 0.001;
const MAX_UINT16 = 65_535;

/** Encodes meters as a device stores them. 16-bit formats hold millimeters; distances beyond 65.535 m become unknown. */
export function encodeDepth(meters: Float32Array, format: DepthFormat): EncodedDepth {
  if (format === 'float32') return { data: new Float32Array(meters).buffer, rawValueToMeters: 1 };
  const units = new Uint16Array(meters.length);
  for (let i = 0; i < meters.length; i++) {
    const unit = Math.round((meters[i] ?? 0) / METERS_PER_UNIT);
    units[i] = unit <= MAX_UINT16 ? unit : 0;
  }
  return { data: units.buffer, rawValueToMeters: METERS_PER_UNIT };
}

/** Converts meters to window-space depth with an infinite far plane, rows from the bottom; 0 stays unknown. */
export function encodeWindowDepth(meters: Float32Array, widthPx: number, nearM: number): EncodedDepth {
  const values = new Float32Array(meters.length);
  const rows = meters.length / widthPx;
  for (let i = 0; i < meters.length; i++) {
    const row = rows - 1 - Math.floor(i / widthPx);
    const at = meters[i] ?? 0;
    values[row * widthPx + (i % widthPx)] = at > 0 ? Math.max(1 - nearM / at, 0) : 0;
  }
  return { data: values.buffer, rawValueToMeters: 1 };
}

export function readDepth(data: ArrayBuffer, format: DepthFormat, index: number): number {
  return (format === 'float32' ? new Float32Array(data) : new Uint16Array(data))[index] ?? 0;
}
