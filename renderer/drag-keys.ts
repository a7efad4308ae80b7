/** Keys held during a drag or with an arrow key. Shift makes it ten times finer, Ctrl or Command snaps. */
export interface DragKeys {
  readonly fine: boolean;
  readonly snap: boolean;
}

export const NO_DRAG_KEYS: DragKeys = { fine: false, snap: false };

type KeyState = Pick<MouseEvent, 'shiftKey' | 'altKey' | 'ctrlKey' | 'metaKey'>;

export function dragKeysOf({ shiftKey, altKey, ctrlKey, metaKey }: KeyState): DragKeys {
  return { fine: shiftKey || altKey, snap: ctrlKey || metaKey };
}

/** How much finer a fine drag is. */
export const FINENESS = 10;
