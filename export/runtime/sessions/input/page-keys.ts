import { MAX_KEYS, type MutableInput, type MutableKeyPress } from './session-input.ts';

/**
 * The keys besides characters that nodes can read. The space bar presses the middle of the view (`page-pointers.ts`); all other keys are
 * left to the browser.
 */
const NAMED: ReadonlySet<string> = new Set(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Delete', 'Backspace', 'Escape']);

const isListed = (key: string): boolean => (key.length === 1 && key !== ' ') || NAMED.has(key);

/** Reads the keys that are pressed while a canvas has the focus. */
export interface PageKeys {
  /** Lists the keys pressed since the last frame, if a node owns the keys. Called once per frame. */
  fill(input: MutableInput): void;
  /** Whether a node owned the keys when they were last listed. */
  areOwned(): boolean;
  dispose(): void;
}

/** Listens for keys. With Control or Command only Z is listed, so that shortcuts of the browser work. */
export function createPageKeys(element: HTMLElement): PageKeys {
  const listeners = new AbortController();
  const waiting: MutableKeyPress[] = Array.from({ length: MAX_KEYS }, () => ({ key: '', shift: false, control: false }));
  let count = 0;
  let owned = false;

  element.addEventListener(
    'keydown',
    (event) => {
      const control = event.ctrlKey || event.metaKey;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      if (!owned || event.altKey || !isListed(key) || (control && key !== 'z')) return;
      event.preventDefault();
      const next = waiting[count];
      if (!next) return;
      count++;
      next.key = key;
      next.shift = event.shiftKey;
      next.control = control;
    },
    { signal: listeners.signal },
  );
  return {
    fill: (input) => {
      for (let i = 0; i < count; i++) Object.assign(input.keys[i] as MutableKeyPress, waiting[i]);
      input.keyCount = count;
      count = 0;
      owned = input.keyOwner !== null;
    },
    areOwned: () => owned,
    dispose: () => listeners.abort(),
  };
}
