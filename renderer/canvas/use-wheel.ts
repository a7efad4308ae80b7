import { type RefObject, useEffect, useState } from 'react';

/**
 * A mouse wheel zooms, a trackpad pans. The browser does not tell them apart: wheels send large equal steps along one axis, trackpads
 * small ones along both.
 *
 * @returns Whether scrolling pans.
 */
export function useWheel(root: RefObject<HTMLElement | null>): boolean {
  const [pans, setPans] = useState(false);
  useEffect(() => {
    const element = root.current;
    if (!element) return;
    const look = (event: WheelEvent) => {
      // A pinch arrives as a wheel event with Ctrl and always zooms.
      if (!event.ctrlKey) setPans(isTrackpad(event));
    };
    element.addEventListener('wheel', look, { capture: true, passive: true });
    return () => element.removeEventListener('wheel', look, { capture: true });
  }, [root]);
  return pans;
}

const WHEEL_STEP_PX = 40;

export function isTrackpad({ deltaX, deltaY, deltaMode }: Pick<WheelEvent, 'deltaX' | 'deltaY' | 'deltaMode'>): boolean {
  if (deltaMode !== 0) return false;
  return deltaX !== 0 || !Number.isInteger(deltaY) || Math.abs(deltaY) < WHEEL_STEP_PX;
}
