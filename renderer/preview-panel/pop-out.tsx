import { type ReactNode, useEffect, useState } from 'react';
import { createPortal } from 'react-dom';
import { keybindingOf } from '../keybinding.ts';
import { watchFileDrops } from '../state/drops/watch-file-drops.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { addToast } from '../state/editor/ui.ts';
import { previewKeybindings, runPreviewKey } from '../state/gizmo/preview-keys.ts';
import { popOutPreview } from '../state/preview/pop-out.ts';

const SIZE = 'popup,width=960,height=720';
/** How often the window is asked whether it was closed. Not all browsers report it. */
const CLOSED_MS = 400;

/** Shows its children in a window of their own. When that window is closed, the preview returns to its panel. */
export function PopOut({ children }: { readonly children: ReactNode }) {
  const editor = useEditor();
  const [body, setBody] = useState<HTMLElement | null>(null);
  useEffect(() => {
    const made = window.open('about:blank', '', SIZE);
    if (made === null) {
      popOutPreview(editor, false);
      addToast(editor.ui, { tone: 'error', text: 'The browser blocked the window. Allow pop-ups for this address, then try again.' });
      return;
    }
    dress(made.document, window.document);
    const unwatch = watchFileDrops(editor, made);
    // Until the preview is clicked, keys reach its window alone.
    made.addEventListener('keydown', (event) => {
      const keybinding = keybindingOf(event, editor.mac);
      if (!made.document.activeElement?.matches('body, iframe') || !previewKeybindings(editor).includes(keybinding)) return;
      event.preventDefault();
      runPreviewKey(editor, keybinding);
    });
    setBody(made.document.body);
    let stopWaiting = () => {};
    const look = () => {
      if (made.closed) popOutPreview(editor, false);
      else stopWaiting = editor.clock.after(CLOSED_MS, look);
    };
    look();
    const close = () => made.close();
    window.addEventListener('pagehide', close);
    return () => {
      stopWaiting();
      unwatch();
      window.removeEventListener('pagehide', close);
      close();
    };
  }, [editor]);
  return body && createPortal(<div className="stage-room stage-popped">{children}</div>, body);
}

/** Gives the empty document the styles and the theme of the editor. */
function dress(made: Document, editor: Document): void {
  made.title = 'Preview';
  for (const { name, value } of editor.documentElement.attributes) made.documentElement.setAttribute(name, value);
  for (const sheet of editor.querySelectorAll('style, link[rel="stylesheet"]')) {
    const copy = made.importNode(sheet, true);
    // The address of an empty document is not that of the editor.
    if (sheet instanceof HTMLLinkElement) (copy as HTMLLinkElement).href = sheet.href;
    made.head.append(copy);
  }
}
