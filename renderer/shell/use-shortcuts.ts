import { useEffect } from 'react';
import { chordOf } from '../key-chord.ts';
import { appCommand, runCommand } from '../state/app-commands.ts';
import { chordsOf, commandOfChord } from '../state/chords.ts';
import { copyInEvent, cutSelection, pasteText } from '../state/clipboard.ts';
import type { Editor } from '../state/editor.ts';
import { isTyping } from './chord.ts';
import { useEditor } from './editor-context.ts';

/**
 * Keys of the whole window. Text fields and the shader editor keep the keys that edit text; a dialog or the palette keeps all.
 * Copy and paste come as the browser's own events, which need no permission.
 */
export function useShortcuts(): void {
  const editor = useEditor();
  useEffect(() => {
    const blocked = () => editor.ui.getState().dialog !== null || editor.ui.getState().palette !== null;
    /** The last press of the pointer was on the canvas: Tab then asks for a node, else it moves the focus. */
    let pointedAtCanvas = false;
    const onPointerDown = (event: PointerEvent) => {
      pointedAtCanvas = isOnCanvas(event.target);
    };
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || blocked()) return;
      const chord = chordOf(event, editor.mac);
      const where = isOnTime(event.target) ? 'time' : 'canvas';
      const id = commandOfChord(editor, chord, isTyping(event.target) && !(isUndo(editor, chord) && isClean(event.target)), where);
      const takesTab = pointedAtCanvas && isOnCanvas(event.target);
      if (chord === 'Tab' && !takesTab) pointedAtCanvas = false;
      if (id === null || !appCommand(id).enabled(editor)) return;
      const isOfTime = appCommand(id).where === 'time';
      if (isOfTime ? isPress(chord, event.target) : chord === 'Tab' ? !takesTab : !hasModifier(chord) && !isOnCanvas(event.target)) return;
      event.preventDefault();
      runCommand(editor, id);
    };
    const onCopy = (event: ClipboardEvent) => {
      if (blocked() || isTyping(event.target) || hasSelectedText()) return;
      const text = copyInEvent(editor);
      if (text === null) return;
      event.preventDefault();
      event.clipboardData?.setData('text/plain', text);
    };
    const onCut = (event: ClipboardEvent) => {
      onCopy(event);
      if (event.defaultPrevented) void cutSelection(editor);
    };
    const onPaste = (event: ClipboardEvent) => {
      if (blocked() || isTyping(event.target)) return;
      if (pasteText(editor, event.clipboardData?.getData('text/plain') ?? '') !== null) event.preventDefault();
    };
    window.addEventListener('pointerdown', onPointerDown, true);
    window.addEventListener('keydown', onKeyDown);
    document.addEventListener('copy', onCopy);
    document.addEventListener('cut', onCut);
    document.addEventListener('paste', onPaste);
    return () => {
      window.removeEventListener('pointerdown', onPointerDown, true);
      window.removeEventListener('keydown', onKeyDown);
      document.removeEventListener('copy', onCopy);
      document.removeEventListener('cut', onCut);
      document.removeEventListener('paste', onPaste);
    };
  }, [editor]);
}

/** Bare keys are the canvas's; the others, and those that no text is typed with, the window's. */
function hasModifier(chord: string): boolean {
  return chord.startsWith('Mod+') || /^F\d+$/.test(chord);
}

function isOnCanvas(target: EventTarget | null): boolean {
  return target === document.body || (target instanceof Element && target.closest('.canvas') !== null);
}

function isOnTime(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.timeline, .stage') !== null;
}

/** Space on a button is for the button. */
function isPress(chord: string, target: EventTarget | null): boolean {
  return chord === 'Space' && target instanceof HTMLButtonElement;
}

function isUndo(editor: Editor, chord: string): boolean {
  return chordsOf(editor, 'edit.undo').includes(chord) || chordsOf(editor, 'edit.redo').includes(chord);
}

/** A number field without text that waits to be taken over has nothing of its own to undo. */
function isClean(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.dataset.clean !== undefined;
}

function hasSelectedText(): boolean {
  return (document.getSelection()?.toString() ?? '') !== '';
}
