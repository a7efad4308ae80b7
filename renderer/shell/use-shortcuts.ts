import { useEffect } from 'react';
import { appCommand, commandOfChord, runCommand } from '../state/app-commands.ts';
import { clipSelection, cutSelection, parseClipping, pasteClipping } from '../state/clipboard.ts';
import { chordOf, isTyping } from './chord.ts';
import { useEditor } from './editor-context.ts';

const PASTE_OFFSET = { x: 32, y: 32 };

/**
 * Keys of the whole window. Text fields and the shader editor keep the keys that edit text; a dialog or the palette keeps all.
 * Copy and paste come as the browser's own events, which need no permission.
 */
export function useShortcuts(): void {
  const editor = useEditor();
  useEffect(() => {
    const blocked = () => editor.ui.getState().dialog !== null || editor.ui.getState().palette !== null;
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || blocked()) return;
      const chord = chordOf(event, editor.mac);
      const id = commandOfChord(chord, isTyping(event.target));
      if (id === null || !appCommand(id).enabled(editor)) return;
      // Tab moves the focus everywhere but on the canvas.
      if (chord === 'Tab' && !isOnCanvas(event.target)) return;
      event.preventDefault();
      runCommand(editor, id);
    };
    const onCopy = (event: ClipboardEvent) => {
      if (blocked() || isTyping(event.target) || hasSelectedText()) return;
      const clipping = clipSelection(editor);
      if (clipping === null) return;
      event.preventDefault();
      event.clipboardData?.setData('text/plain', JSON.stringify(clipping));
    };
    const onCut = (event: ClipboardEvent) => {
      onCopy(event);
      if (event.defaultPrevented) void cutSelection(editor);
    };
    const onPaste = (event: ClipboardEvent) => {
      if (blocked() || isTyping(event.target)) return;
      const clipping = parseClipping(event.clipboardData?.getData('text/plain') ?? '');
      if (clipping === null) return;
      event.preventDefault();
      pasteClipping(editor, clipping, 'Paste', PASTE_OFFSET);
    };
    window.addEventListener('keydown', onKeyDown);
    document.addEventListener('copy', onCopy);
    document.addEventListener('cut', onCut);
    document.addEventListener('paste', onPaste);
    return () => {
      window.removeEventListener('keydown', onKeyDown);
      document.removeEventListener('copy', onCopy);
      document.removeEventListener('cut', onCut);
      document.removeEventListener('paste', onPaste);
    };
  }, [editor]);
}

function isOnCanvas(target: EventTarget | null): boolean {
  return target === document.body || (target instanceof Element && target.closest('.canvas') !== null);
}

function hasSelectedText(): boolean {
  return (document.getSelection()?.toString() ?? '') !== '';
}
