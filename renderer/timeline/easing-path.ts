import { type Easing, type Handles, handlesOf } from '../../nodes/kit/ease.ts';

/** For the `d` of a path in a square of 1 by 1, y down. */
export function handlesPath([x1, y1, x2, y2]: Handles): string {
  return `M0 1C${x1} ${1 - y1} ${x2} ${1 - y2} 1 0`;
}

export function easingPath(easing: Easing): string {
  const handles = handlesOf(easing);
  return handles === null ? 'M0 1H1V0' : handlesPath(handles);
}
