/** A press that moves farther is a drag. */
const STILL_PX = 3;

/** A pointer that is held still for this time does not drag. */
const REST_MS = 150;

/**
 * Reports when a pressed pointer starts to move on the page, and when it rests or is released: drags of params, gizmos, nodes, wires and
 * views alike.
 *
 * @returns A function that ends the reports.
 */
export function watchDrags(page: Window, wait: (ms: number) => Promise<void>, onChange: (dragging: boolean) => void): () => void {
  let press: { readonly x: number; readonly y: number } | null = null;
  let dragging = false;
  /** Whether the press has moved far enough. */
  let far = false;
  let moves = 0;
  const set = (next: boolean) => {
    if (next === dragging) return;
    dragging = next;
    onChange(next);
  };
  const onDown = ({ clientX: x, clientY: y }: PointerEvent) => {
    press = { x, y };
    far = false;
  };
  const onMove = ({ clientX, clientY, buttons }: PointerEvent) => {
    if (buttons === 0) onEnd();
    if (!press) return;
    far ||= Math.hypot(clientX - press.x, clientY - press.y) > STILL_PX;
    if (!far) return;
    set(true);
    const mine = ++moves;
    void wait(REST_MS).then(() => {
      if (mine === moves) set(false);
    });
  };
  const onEnd = () => {
    press = null;
    set(false);
  };
  // While capturing, the window also sees elements lose the focus.
  const onBlur = ({ target }: Event) => {
    if (target === page) onEnd();
  };
  const listeners = [
    ['pointerdown', onDown],
    ['pointermove', onMove],
    ['pointerup', onEnd],
    ['pointercancel', onEnd],
    ['blur', onBlur],
  ] as const;
  // While capturing, because handlers of drags stop the events.
  for (const [kind, listener] of listeners) page.addEventListener(kind, listener as EventListener, true);
  return () => {
    for (const [kind, listener] of listeners) page.removeEventListener(kind, listener as EventListener, true);
  };
}
