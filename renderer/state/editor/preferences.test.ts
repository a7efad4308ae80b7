import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { appCommand, appCommandIds } from '../commands/app-commands.ts';
import { commandOfKeybinding, keybindingsOf, resetKeybindings, setKeybinding } from '../commands/keybindings.ts';
import { openPath } from '../files/files.ts';
import { DEFAULT_PREFERENCES, keepPreferences, loadPreferences } from './preferences.ts';

function memory(text: string | null = null) {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  };
}

describe('preferences', () => {
  test('are found again in the next window', async () => {
    const storage = memory();
    const { editor } = await openTestEditor();
    keepPreferences(editor, storage);
    editor.preferences.setState({ theme: 'light', motion: 'reduced', scale: 1.25 });
    setKeybinding(editor, 'graph.note', 'Mod+Alt+J');
    expect(loadPreferences(storage)).toEqual({ ...editor.preferences.getState(), theme: 'light' });
    expect(loadPreferences(storage).keybindings['graph.note']).toEqual(['Mod+Alt+J']);
  });

  test.each([
    null,
    'nonsense',
    '[]',
    'null',
    '{"theme":7,"motion":{},"scale":9,"keybindings":["x"],"recent":[{"path":1}],"colmap":{},"blender":3}',
  ])('of %s are the defaults', (text) => {
    const { keybindings, ...others } = loadPreferences(memory(text));
    expect(others).toEqual({
      theme: 'system',
      motion: 'system',
      wheel: 'auto',
      scale: 1,
      thumbnails: true,
      renderSize: 'auto',
      recent: [],
      favorites: [],
      recentTypes: [],
      colmap: '',
      blender: '',
      instantMeshes: '',
    });
    expect(appCommandIds().some((id) => Object.hasOwn(keybindings, id))).toBe(false);
  });

  test('remember what was worked on, the last first and each once', async () => {
    const { editor } = await openTestEditor();
    for (let i = 0; i < 12; i++) await openPath(editor, `/project${i}`);
    await openPath(editor, '/project5');
    const { recent } = editor.preferences.getState();
    expect(recent.map(({ path }) => path)).toEqual(['/project5', ...[11, 10, 9, 8, 7, 6, 4].map((i) => `/project${i}`)]);
    expect(recent[0]?.title).toBe('Test');
  });
});

describe('keys', () => {
  const editor = () => openTestEditor().then((opened) => opened.editor);

  test('are those of the table until the person chooses others', async () => {
    const mine = await editor();
    expect(commandOfKeybinding(mine, 'M', false)).toBe('edit.mute');
    setKeybinding(mine, 'edit.mute', 'Q');
    expect(commandOfKeybinding(mine, 'Q', false)).toBe('edit.mute');
    expect(commandOfKeybinding(mine, 'M', false)).toBeNull();
    resetKeybindings(mine);
    expect(commandOfKeybinding(mine, 'M', false)).toBe('edit.mute');
    expect(mine.preferences.getState().keybindings).toEqual(DEFAULT_PREFERENCES.keybindings);
  });

  test('have one command each: who takes them from another leaves that one its others', async () => {
    const mine = await editor();
    setKeybinding(mine, 'graph.note', 'Mod+Y');
    expect(commandOfKeybinding(mine, 'Mod+Y', false)).toBe('graph.note');
    expect(keybindingsOf(mine, 'edit.redo')).toEqual(['Mod+Shift+Z']);
  });

  test('can be taken away', async () => {
    const mine = await editor();
    setKeybinding(mine, 'edit.delete', null);
    expect(commandOfKeybinding(mine, 'Delete', false)).toBeNull();
  });

  test('of the table are given once', async () => {
    const mine = await editor();
    for (const where of ['time', undefined]) {
      const all = appCommandIds().flatMap((id) => (appCommand(id).where === where ? keybindingsOf(mine, id) : []));
      expect(new Set(all).size).toBe(all.length);
    }
  });
});
