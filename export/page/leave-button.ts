import { element } from './dom.ts';
import type { SessionMode } from './session-modes.ts';

/** The button that ends a session that the visitor entered. */
export interface LeaveButton {
  readonly element: HTMLButtonElement;
  /** Marks the page with the mode that is shown; null selects the orbit view. Returns whether it is another than before. */
  setMode(mode: SessionMode | null): boolean;
}

const LEAVE: Readonly<Record<SessionMode, string>> = { ar: 'Leave AR', camera: 'Stop the camera', vr: 'Leave VR' };

/** Returns null in pages whose program plays in no session that a visitor enters. */
export function createLeaveButton(document: Document, onLeave: () => void): LeaveButton | null {
  const button = element(document, 'button', { className: 'leave', hidden: true, attributes: { type: 'button' }, onClick: onLeave });
  let shown: SessionMode | null = null;
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && shown === 'camera') onLeave();
  });
  return {
    element: button,
    setMode: (mode) => {
      if (mode === shown) return false;
      shown = mode;
      const { dataset } = document.documentElement;
      if (mode === null) delete dataset.way;
      else dataset.way = mode;
      button.hidden = mode === null;
      button.textContent = mode === null ? '' : LEAVE[mode];
      return true;
    },
  };
}
