import type { Editor } from './state/editor/editor.ts';
import { guardPreview } from './state/preview/stopped-preview.ts';

const LOCK = 'scrim-project ';

/**
 * Connects `guardPreview` to the page: its storage, the `pagehide` event, the Shift key, and a Web Lock per open project that other
 * windows can query.
 */
export function guardPreviewInPage(editor: Editor): void {
  let shift = false;
  // Projects are opened by a click or Enter.
  const onClick = (event: MouseEvent) => {
    shift = event.shiftKey;
  };
  const onKey = (event: KeyboardEvent) => {
    shift = event.key === 'Enter' && event.shiftKey;
  };
  window.addEventListener('click', onClick, { capture: true });
  window.addEventListener('keydown', onKey, { capture: true });
  const guard = guardPreview(editor, { storage: localStorage, asks: () => shift, isOpenElsewhere });
  window.addEventListener('pagehide', guard.leave);
  holdLocks(editor);
}

/** Holds a shared lock for the open project. The browser releases it when the window closes or crashes. */
function holdLocks({ document }: Pick<Editor, 'document'>): void {
  let release = () => {};
  document.subscribe(({ open }, before) => {
    if (open?.displayPath === before.open?.displayPath) return;
    release();
    if (open === null) return;
    const released = new Promise<void>((resolve) => {
      release = resolve;
    });
    void navigator.locks.request(LOCK + open.displayPath, { mode: 'shared' }, () => released);
  });
}

/** Whether another window holds the lock. Called before this window requests it. */
async function isOpenElsewhere(path: string): Promise<boolean> {
  const { held = [] } = await navigator.locks.query();
  return held.some(({ name }) => name === LOCK + path);
}
