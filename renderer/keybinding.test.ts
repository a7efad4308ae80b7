import { expect, test } from '@jest/globals';
import { openTestEditor } from '../tests/support/test-editor.ts';
import { type KeyPress, keybindingOf } from './keybinding.ts';
import { commandOfKeybinding } from './state/commands/keybindings.ts';

/** What a key sends: the character that it produces, and the place of its key on a US keyboard, which does not count. */
interface Sent extends Partial<KeyPress> {
  readonly key: string;
  readonly code: string;
}

// German and French keyboards, Caps Lock, and AltGr, which Windows reports as Ctrl with Alt.
test.each<[string, Sent, string | null]>([
  ['German Z', { key: 'z', code: 'KeyY', ctrlKey: true }, 'edit.undo'],
  ['German Y', { key: 'y', code: 'KeyZ', ctrlKey: true }, 'edit.redo'],
  ['German ?', { key: '?', code: 'Minus', shiftKey: true }, 'help.shortcuts'],
  ['German AltGr+Q', { key: '@', code: 'KeyQ', ctrlKey: true, altKey: true }, null],
  ['German ß, where ? lies', { key: 'ß', code: 'Minus' }, null],
  ['French ?', { key: '?', code: 'KeyM', shiftKey: true }, 'help.shortcuts'],
  ['French comma, where M lies', { key: ',', code: 'KeyM' }, null],
  ['French A', { key: 'a', code: 'KeyQ', ctrlKey: true }, 'edit.select-all'],
  ['French M', { key: 'm', code: 'Semicolon', ctrlKey: true }, 'view.problems'],
  ['French Z', { key: 'z', code: 'KeyW', ctrlKey: true, shiftKey: true }, 'edit.redo'],
  ['French W', { key: 'w', code: 'KeyZ' }, 'gizmo.move'],
  ['a letter with Caps Lock', { key: 'T', code: 'KeyT' }, 'view.thumbnails'],
  ['a letter with Shift', { key: 'T', code: 'KeyT', shiftKey: true }, 'view.timeline'],
])('%s runs the command of the character that it produces', async (_, { key, ...pressed }, command) => {
  const { editor } = await openTestEditor();
  const press = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...pressed, key };
  expect(commandOfKeybinding(editor, keybindingOf(press, false), false)).toBe(command);
});

test.each([
  ['&', 'Digit1', false, '&'],
  ['1', 'Digit1', true, '1'],
])('French digits need Shift, which is not part of the keybinding: %s', (key, _code, shiftKey, keybinding) => {
  expect(keybindingOf({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey }, false)).toBe(keybinding);
});
