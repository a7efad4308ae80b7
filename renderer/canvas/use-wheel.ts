import { type RefObject, useEffect, useState } from 'react';

/**
 * A mouse wheel zooms, a trackpad pans, as each hand expects. The browser does not say which it is: wheels turn in large even
 * steps along one axis, trackpads glide in small ones along both. Returns whether to pan.
 */
export function useWheel(root: RefObject<HTMLElement | null>): boolean {
  const [pans, setPans] = useState(false);
  useEffect(() => {
    const element = root.current;
    if (!element) return;
    const look = (event: WheelEvent) => {
      // Pinching arrives as a wheel with Ctrl and zooms in either mode.
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
