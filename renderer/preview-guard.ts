import type { Editor } from './state/editor/editor.ts';
import { guardPreview } from './state/preview/stopped-preview.ts';

const LOCK = 'scrim-project ';

/** Watches over the preview with what a page has: its storage, its end, its keys, and locks by which windows know of each other. */
export function guardPreviewInPage(editor: Editor): void {
  let shift = false;
  // A project is opened by a click, or by Enter.
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

/** Holds a lock of the open project's, which goes with the window however that ends. */
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

/** Asked before this window holds the lock itself. */
async function isOpenElsewhere(path: string): Promise<boolean> {
  const { held = [] } = await navigator.locks.query();
  return held.some(({ name }) => name === LOCK + path);
}
