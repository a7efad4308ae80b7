import { useEffect } from 'react';
import { keybindingOf } from '../keybinding.ts';
import { clipboardTextOfSelection, cutSelection, pasteText } from '../state/clipboard/clipboard.ts';
import { appCommand, runCommand } from '../state/commands/app-commands.ts';
import { commandOfKeybinding, keybindingsOf } from '../state/commands/keybindings.ts';
import { isTyping } from '../state/commands/show-keybinding.ts';
import type { Editor } from '../state/editor/editor.ts';
import { useEditor } from '../state/editor/editor-context.ts';

/**
 * Runs commands by the keybindings of the window. Some keys run other commands in the timeline and the preview than on the canvas; all
 * other panels have the keys of the canvas. The panel under the pointer decides, except while the timeline or the preview has the focus.
 *
 * Text fields and the shader editor keep the keys that edit text, other focused controls keep the keys that operate them, and a dialog or
 * the palette keeps all keys. Copy and paste use the clipboard events of the browser, which need no permission.
 */
export function useShortcuts(): void {
  const editor = useEditor();
  useEffect(() => {
    const blocked = () => editor.ui.getState().dialog !== null || editor.ui.getState().palette !== null;
    /** Whether the last pointer press was on the canvas: then Tab opens the palette, else it moves the focus. */
    let pointedAtCanvas = false;
    let hovered: EventTarget | null = null;
    const onPointerDown = (event: PointerEvent) => {
      pointedAtCanvas = isOnCanvas(event.target);
    };
    const onPointerOver = (event: PointerEvent) => {
      hovered = event.target;
    };
    let held: { readonly key: string; readonly release: (editor: Editor) => void } | null = null;
    const onKeyDown = (event: KeyboardEvent) => {
      const keybinding = keybindingOf(event, editor.mac);
      const [focused, pointed] = [panelOf(event.target), panelOf(hovered)];
      // React Flow claims Space in the whole page, to pan with it.
      const isClaimed = event.defaultPrevented && !(keybinding === 'Space' && pointed === 'time');
      if (isClaimed || blocked()) return;
      const stays = focused === 'time' || CANVAS_KEYS.includes(keybinding);
      const where = (stays ? (focused ?? pointed) : (pointed ?? focused)) ?? 'canvas';
      const id = commandOfKeybinding(
        editor,
        keybinding,
        isTyping(event.target) && !(isUndo(editor, keybinding) && isClean(event.target)),
        where,
      );
      const takesTab = pointedAtCanvas && isOnCanvas(event.target);
      if (keybinding === 'Tab' && !takesTab) pointedAtCanvas = false;
      if (id === null || !appCommand(id).enabled(editor)) return;
      if (keybinding === 'Tab' ? !takesTab : operates(keybinding, event.target)) return;
      event.preventDefault();
      const { release } = appCommand(id);
      if (release !== undefined && event.repeat) return;
      if (release !== undefined) held = { key: event.code, release };
      runCommand(editor, id);
    };
    /** Ends a command that shows something while its key is held. */
    const letGo = () => {
      held?.release(editor);
      held = null;
    };
    const onKeyUp = (event: KeyboardEvent) => {
      if (event.code === held?.key) letGo();
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
    window.addEventListener('pointerover', onPointerOver, true);
    window.addEventListener('keydown', onKeyDown);
    window.addEventListener('keyup', onKeyUp, true);
    window.addEventListener('blur', letGo);
    document.addEventListener('copy', onCopy);
    document.addEventListener('cut', onCut);
    document.addEventListener('paste', onPaste);
    return () => {
      window.removeEventListener('pointerdown', onPointerDown, true);
      window.removeEventListener('pointerover', onPointerOver, true);
      window.removeEventListener('keydown', onKeyDown);
      window.removeEventListener('keyup', onKeyUp, true);
      window.removeEventListener('blur', letGo);
      document.removeEventListener('copy', onCopy);
      document.removeEventListener('cut', onCut);
      document.removeEventListener('paste', onPaste);
    };
  }, [editor]);
}

function isOnCanvas(target: EventTarget | null): boolean {
  return target === document.body || (target instanceof Element && target.closest('.canvas') !== null);
}

/** The panel whose keys apply to an element: `time` in the timeline and the preview, `canvas` on the canvas, else null. */
function panelOf(target: EventTarget | null): 'canvas' | 'time' | null {
  if (isOnTime(target)) return 'time';
  return target !== document.body && isOnCanvas(target) ? 'canvas' : null;
}

function isOnTime(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.timeline, .stage') !== null;
}

/** Keys that act on the focused node or wire, even if the pointer is over another panel. */
const CANVAS_KEYS = ['Enter', 'Delete', 'Backspace', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'];

/** Keys that operate a focused control, such as a button, a list or a slider. */
const CONTROL_KEYS = ['Space', 'Enter', 'Delete', 'Backspace', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End'];

/** Whether the key operates the focused control. The canvas, the timeline and the preview themselves are not controls. */
function operates(keybinding: string, target: EventTarget | null): boolean {
  if (!CONTROL_KEYS.includes(keybinding) || !(target instanceof Element)) return false;
  if (target instanceof HTMLButtonElement) return keybinding === 'Space' || keybinding === 'Enter' || !isOnTime(target);
  return target !== document.body && !isOnCanvas(target) && !isOnTime(target);
}

function isUndo(editor: Editor, keybinding: string): boolean {
  return keybindingsOf(editor, 'edit.undo').includes(keybinding) || keybindingsOf(editor, 'edit.redo').includes(keybinding);
}

/** Whether a field has no pending text. It then has nothing to undo, so undo applies to the document. */
function isClean(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.dataset.clean !== undefined;
}

function hasSelectedText(): boolean {
  return (document.getSelection()?.toString() ?? '') !== '';
}
