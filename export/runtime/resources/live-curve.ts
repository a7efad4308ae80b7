import { CURVE_NUMBERS, sampleCurve } from '../../../nodes/kit/curve.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createLiveTable, type LiveTable } from './live-table.ts';

/** The curve of a param as a texture of heights. */
export function createLiveCurve(objects: GlObjects): LiveTable {
  return createLiveTable(objects, { numbers: CURVE_NUMBERS, channels: 1, sample: sampleCurve });
}
