import { describe, expect, test } from '@jest/globals';
import type { HostInput } from '../../../app/contract/contract.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { appCommandIds, runCommand } from './app-commands.ts';
import { setKeybinding } from './keybindings.ts';
import { MENUS, syncNativeMenus } from './menus.ts';

async function followed() {
  const { editor, host, clock } = await openTestEditor();
  const stop = syncNativeMenus(editor);
  const shown = () => host.calls.filter(({ method }) => method === 'menu.show').map(({ input }) => input as HostInput<'menu.show'>);
  const entry = (command: string) => {
    const entries = shown()
      .at(-1)
      ?.menus.flatMap((menu) => menu.entries);
    return entries?.find((candidate) => candidate !== 'line' && candidate.command === command);
  };
  return { editor, clock, stop, shown, entry };
}

describe('the window’s own menu', () => {
  test('has every command of the editor once', () => {
    const listed = MENUS.flatMap(({ entries }) => entries.filter((id) => id !== 'line'));
    expect([...listed].sort()).toEqual([...appCommandIds()].sort());
  });

  test('follows what can be done, and is not told the same twice', async () => {
    const { editor, clock, shown, entry } = await followed();
    expect(entry('edit.duplicate')).toMatchObject({ enabled: false, label: 'Duplicate', keybinding: 'Mod+D' });
    const definition = editor.document.getState().library.definition('filter/sepia');
    if (!definition) throw new Error('There is no sepia.');
    addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    clock.pass(100);
    expect([entry('edit.duplicate'), entry('edit.undo')]).toMatchObject([{ enabled: true }, { enabled: true }]);
    const count = shown().length;
    editor.preview.setState((state) => ({ ...state }));
    clock.pass(100);
    expect(shown()).toHaveLength(count);
  });

  test('ticks what is on', async () => {
    const { editor, clock, entry } = await followed();
    expect([entry('view.history'), entry('edit.mute'), entry('gizmo.move'), entry('view.fit')]).toMatchObject([
      { checked: false },
      { checked: false },
      { checked: true },
      { checked: null },
    ]);
    runCommand(editor, 'view.history');
    runCommand(editor, 'gizmo.rotate');
    const definition = editor.document.getState().library.definition('filter/sepia');
    if (!definition) throw new Error('There is no sepia.');
    addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    runCommand(editor, 'edit.mute');
    clock.pass(100);
    expect([entry('view.history'), entry('edit.mute'), entry('gizmo.move'), entry('gizmo.rotate')]).toMatchObject([
      { checked: true },
      { checked: true },
      { checked: false },
      { checked: true },
    ]);
  });

  test('follows other keys', async () => {
    const { editor, clock, entry } = await followed();
    setKeybinding(editor, 'view.fit', 'Mod+9');
    clock.pass(100);
    expect(entry('view.fit')).toMatchObject({ keybinding: 'Mod+9' });
    setKeybinding(editor, 'view.fit', null);
    clock.pass(100);
    expect(entry('view.fit')).toMatchObject({ keybinding: null });
  });

  test('offers nothing while a question is open', async () => {
    const { editor, clock, entry } = await followed();
    expect(entry('file.new')).toMatchObject({ enabled: true });
    editor.ui.setState({ dialog: { kind: 'find' } });
    clock.pass(100);
    expect(entry('file.new')).toMatchObject({ enabled: false });
  });

  test('is left alone afterwards', async () => {
    const { editor, clock, stop, shown } = await followed();
    stop();
    editor.ui.setState({ dialog: { kind: 'find' } });
    clock.pass(100);
    expect(shown()).toHaveLength(1);
  });
});
