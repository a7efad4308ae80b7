import type { Pinhole } from '../../../nodes/kit/capture.ts';
import { eachPointAhead, type SourceView } from '../source-view.ts';
import type { DepthMap } from './depth-map.ts';

/**
 * The depth of the points of a reconstruction that a photograph shows, along the axis of its camera and in its unit; other pixels are 0. Null
 * without points, and for 360° photographs.
 *
 * @param pinhole The camera of the photograph without distortion.
 */
export function depthOfPoints(view: SourceView, pinhole: Pinhole): DepthMap | null {
  const { widthPx, heightPx } = pinhole;
  if (pinhole.projection !== undefined || view.observations.length === 0) return null;
  const values = new Float32Array(widthPx * heightPx);
  eachPointAhead(view, (_column, _row, x, y, depth) => {
    const column = Math.floor(x * pinhole.fxPx + pinhole.cxPx);
    const row = Math.floor(y * pinhole.fyPx + pinhole.cyPx);
    if (column < 0 || row < 0 || column >= widthPx || row >= heightPx) return;
    const at = row * widthPx + column;
    const known = values[at] ?? 0;
    values[at] = known > 0 ? Math.min(known, depth) : depth;
  });
  return { widthPx, heightPx, values };
}
