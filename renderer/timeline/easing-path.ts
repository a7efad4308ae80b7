import { type Easing, type Handles, handlesOf } from '../../nodes/kit/ease.ts';

/** SVG path data of a Bézier easing in a unit square, y down. */
export function handlesPath([x1, y1, x2, y2]: Handles): string {
  return `M0 1C${x1} ${1 - y1} ${x2} ${1 - y2} 1 0`;
}

export function easingPath(easing: Easing): string {
  const handles = handlesOf(easing);
  return handles === null ? 'M0 1H1V0' : handlesPath(handles);
}
