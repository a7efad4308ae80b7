import { useEffect } from 'react';
import { keybindingOf } from '../keybinding.ts';
import { clipboardTextOfSelection, cutSelection, pasteText } from '../state/clipboard/clipboard.ts';
import { appCommand, runCommand } from '../state/commands/app-commands.ts';
import { commandOfKeybinding, keybindingsOf } from '../state/commands/keybindings.ts';
import { isTyping } from '../state/commands/show-keybinding.ts';
import type { Editor } from '../state/editor/editor.ts';
import { useEditor } from '../state/editor/editor-context.ts';

/**
 * Keybindings of the window. Text fields and the shader editor keep the keys that edit text; a dialog or the palette keeps all keys.
 * Copy and paste use the clipboard events of the browser, which need no permission.
 */
export function useShortcuts(): void {
  const editor = useEditor();
  useEffect(() => {
    const blocked = () => editor.ui.getState().dialog !== null || editor.ui.getState().palette !== null;
    /** Whether the last pointer press was on the canvas: then Tab opens the palette, else it moves the focus. */
    let pointedAtCanvas = false;
    const onPointerDown = (event: PointerEvent) => {
      pointedAtCanvas = isOnCanvas(event.target);
    };
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || blocked()) return;
      const keybinding = keybindingOf(event, editor.mac);
      const where = isOnTime(event.target) ? 'time' : 'canvas';
      const id = commandOfKeybinding(
        editor,
        keybinding,
        isTyping(event.target) && !(isUndo(editor, keybinding) && isClean(event.target)),
        where,
      );
      const takesTab = pointedAtCanvas && isOnCanvas(event.target);
      if (keybinding === 'Tab' && !takesTab) pointedAtCanvas = false;
      if (id === null || !appCommand(id).enabled(editor)) return;
      const isOfTime = appCommand(id).where === 'time';
      if (
        isOfTime
          ? isPress(keybinding, event.target)
          : keybinding === 'Tab'
            ? !takesTab
            : !hasModifier(keybinding) && !isOnCanvas(event.target)
      )
        return;
      event.preventDefault();
      runCommand(editor, id);
    };
    const onCopy = (event: ClipboardEvent) => {
      if (blocked() || isTyping(event.target) || hasSelectedText()) return;
      const text = clipboardTextOfSelection(editor);
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

/** Whether a keybinding works in the whole window: with a modifier, or a function key. Others work on the canvas only. */
function hasModifier(keybinding: string): boolean {
  return keybinding.startsWith('Mod+') || /^F\d+$/.test(keybinding);
}

function isOnCanvas(target: EventTarget | null): boolean {
  return target === document.body || (target instanceof Element && target.closest('.canvas') !== null);
}

function isOnTime(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.timeline, .stage') !== null;
}

/** Whether the key presses the focused button. */
function isPress(keybinding: string, target: EventTarget | null): boolean {
  return keybinding === 'Space' && target instanceof HTMLButtonElement;
}

function isUndo(editor: Editor, keybinding: string): boolean {
  return keybindingsOf(editor, 'edit.undo').includes(keybinding) || keybindingsOf(editor, 'edit.redo').includes(keybinding);
}

/** A field without pending text has nothing to undo, so undo goes to the document. */
function isClean(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.dataset.clean !== undefined;
}

function hasSelectedText(): boolean {
  return (document.getSelection()?.toString() ?? '') !== '';
}
