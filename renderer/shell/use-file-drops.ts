import { useEffect } from 'react';
import { debounce } from '../clock.ts';
import { watchFileDrops } from '../state/drops/watch-file-drops.ts';
import { useEditor } from '../state/editor/editor-context.ts';

/** Browsers repeat `dragover` at least three times a second. */
const GONE_MS = 700;

/** Takes files that are dropped on parts of the window without a place for them, and notices when dragged files leave the windows. */
export function useFileDrops(): void {
  const editor = useEditor();
  useEffect(() => {
    const { ui, clock } = editor;
    const gone = debounce(clock, GONE_MS, () => ui.setState({ fileDrags: 0 }));
    const stop = ui.subscribe((now, before) => {
      if (now.fileDrags !== before.fileDrags && now.fileDrags > 0) gone.trigger();
    });
    const unwatch = watchFileDrops(editor, window);
    return () => {
      unwatch();
      stop();
      gone.cancel();
    };
  }, [editor]);
}
