import { getOwn } from '../../../export/graph/record.ts';

const NAMES: Readonly<Record<string, string>> = {
  ArrowLeft: 'Left',
  ArrowRight: 'Right',
  ArrowUp: 'Up',
  ArrowDown: 'Down',
  Mod: 'Ctrl',
  Delete: 'Del',
};
const MAC_SIGNS: Readonly<Record<string, string>> = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Mod: '⌘',
  Shift: '⇧',
  Alt: '⌥',
  Ctrl: '⌃',
  Delete: '⌫',
  Backspace: '⌫',
  Tab: '⇥',
};

/** Text of a keybinding for menus and tooltips: `⇧⌘Z` on a Mac, `Ctrl+Shift+Z` elsewhere. */
export function showKeybinding(keybinding: string, mac: boolean): string {
  const parts = keybinding.split('+');
  if (!mac) return parts.map((part) => getOwn(NAMES, part) ?? part).join('+');
  const order = ['Ctrl', 'Alt', 'Shift', 'Mod'];
  const modifiers = parts.slice(0, -1).sort((a, b) => order.indexOf(a) - order.indexOf(b));
  return [...modifiers, parts.at(-1) ?? ''].map((part) => getOwn(MAC_SIGNS, part) ?? part).join('');
}

/** Whether the element edits text: a text field, or an element marked with `data-typing`. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest('[data-typing]') !== null) return true;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !['checkbox', 'range', 'color', 'button'].includes(target.type);
}
