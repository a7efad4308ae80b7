import type { Editor } from '../editor/editor.ts';
import { carriesFiles, noteFileDrag, takeDrop, takesDrops } from './take-drop.ts';

/**
 * Adds files that are dropped on parts of a window without a place for them, in free space on the canvas. Nowhere in the window does the
 * browser open a dropped file.
 *
 * @returns A function that stops this.
 */
export function watchFileDrops(editor: Editor, window: Window): () => void {
  const end = () => editor.ui.setState({ fileDrags: 0 });
  const onDrag = (event: DragEvent) => {
    if (event.dataTransfer === null || !carriesFiles(event.dataTransfer)) return;
    event.preventDefault();
    const takes = takesDrops(editor);
    event.dataTransfer.dropEffect = takes ? 'copy' : 'none';
    if (takes && event.dataTransfer.types.includes('Files')) noteFileDrag(editor.ui);
  };
  const onDrop = (event: DragEvent) => {
    end();
    if (event.dataTransfer === null || !carriesFiles(event.dataTransfer)) return;
    if (!event.defaultPrevented && takesDrops(editor)) takeDrop(editor, event.dataTransfer);
    event.preventDefault();
  };
  const listeners = [
    ['dragenter', onDrag],
    ['dragover', onDrag],
    ['drop', onDrop],
    ['dragend', end],
  ] as const;
  for (const [kind, listener] of listeners) window.addEventListener(kind, listener as EventListener);
  return () => {
    for (const [kind, listener] of listeners) window.removeEventListener(kind, listener as EventListener);
  };
}
