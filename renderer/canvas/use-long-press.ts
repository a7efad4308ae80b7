import { type RefObject, useEffect } from 'react';
import { useEditor } from '../state/editor/editor-context.ts';

/** Duration of a long press on Android, and the distance that a resting finger may move. */
const HOLD_MS = 500;
const TREMBLE_PX = 10;

/**
 * Opens the context menu on a long press of a finger or pen. Browsers send `contextmenu` for it on some systems only, and never on iOS.
 */
export function useLongPress(root: RefObject<HTMLElement | null>): void {
  const { clock } = useEditor();
  useEffect(() => {
    const element = root.current;
    if (!element) return;
    let held: { readonly id: number; readonly x: number; readonly y: number; readonly forget: () => void } | null = null;
    let asked = false;
    const forget = () => {
      held?.forget();
      held = null;
    };
    const onDown = ({ pointerType, pointerId, isPrimary, clientX, clientY, target }: PointerEvent) => {
      forget();
      asked = false;
      // A second finger makes it a pinch.
      if (pointerType === 'mouse' || !isPrimary || !(target instanceof Element)) return;
      const ask = () => {
        held = null;
        asked = true;
        target.dispatchEvent(new MouseEvent('contextmenu', { bubbles: true, cancelable: true, button: 2, clientX, clientY }));
      };
      held = { id: pointerId, x: clientX, y: clientY, forget: clock.after(HOLD_MS, ask) };
    };
    const onMove = ({ pointerId, clientX, clientY }: PointerEvent) => {
      if (held?.id === pointerId && Math.hypot(clientX - held.x, clientY - held.y) > TREMBLE_PX) forget();
    };
    // The browser opened the menu itself.
    const onMenu = ({ isTrusted }: MouseEvent) => {
      if (isTrusted) forget();
    };
    // Prevents the click that would close the menu.
    const onLift = (event: TouchEvent) => {
      if (asked && event.cancelable) event.preventDefault();
    };
    const options = { capture: true };
    element.addEventListener('pointerdown', onDown, options);
    element.addEventListener('pointermove', onMove, options);
    element.addEventListener('contextmenu', onMenu, options);
    element.addEventListener('touchend', onLift, { capture: true, passive: false });
    for (const end of ['pointerup', 'pointercancel'] as const) window.addEventListener(end, forget, options);
    return () => {
      forget();
      element.removeEventListener('pointerdown', onDown, options);
      element.removeEventListener('pointermove', onMove, options);
      element.removeEventListener('contextmenu', onMenu, options);
      element.removeEventListener('touchend', onLift, options);
      for (const end of ['pointerup', 'pointercancel'] as const) window.removeEventListener(end, forget, options);
    };
  }, [root, clock]);
}
