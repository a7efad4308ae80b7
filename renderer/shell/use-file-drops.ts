import { useEffect } from 'react';
import { debounce } from '../clock.ts';
import { carriesFiles, noteFileDrag, takeDrop, takesDrops } from '../state/drops/take-drop.ts';
import { useEditor } from '../state/editor/editor-context.ts';

/** Browsers repeat `dragover` at least three times a second. */
const GONE_MS = 700;

/**
 * Adds files that are dropped on parts of the window without a place for them, in free space on the canvas. Nowhere in the window does the
 * browser open a dropped file.
 */
export function useFileDrops(): void {
  const editor = useEditor();
  useEffect(() => {
    const { ui, clock } = editor;
    const end = () => ui.setState({ fileDrags: 0 });
    const gone = debounce(clock, GONE_MS, end);
    const stop = ui.subscribe((now, before) => {
      if (now.fileDrags !== before.fileDrags && now.fileDrags > 0) gone.trigger();
    });
    const onDrag = (event: DragEvent) => {
      if (event.dataTransfer === null || !carriesFiles(event.dataTransfer)) return;
      event.preventDefault();
      const takes = takesDrops(editor);
      event.dataTransfer.dropEffect = takes ? 'copy' : 'none';
      if (takes && event.dataTransfer.types.includes('Files')) noteFileDrag(ui);
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
      stop();
      gone.cancel();
    };
  }, [editor]);
}
