import { GRADIENT_NUMBERS, sampleGradient } from '../../../nodes/kit/gradient.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import { createLiveTable, type LiveTable } from './live-table.ts';

/** The gradient of a param as a texture of premultiplied colors. */
export function createLiveGradient(objects: GlObjects): LiveTable {
  return createLiveTable(objects, { numbers: GRADIENT_NUMBERS, channels: 4, sample: sampleGradient });
}
