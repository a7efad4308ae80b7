import { beforeEach, describe, expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { PreviewStatus } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { openPath } from '../files/files.ts';
import { guardPreview, startPreview } from './stopped-preview.ts';

/** Of a browser: it outlives the windows. */
function createStorage() {
  const values = new Map<string, string>();
  return {
    values,
    getItem: (key: string) => values.get(key) ?? null,
    setItem: (key: string, value: string) => void values.set(key, value),
    removeItem: (key: string) => void values.delete(key),
  };
}

describe('the preview of a project that ended the last one', () => {
  let storage: ReturnType<typeof createStorage>;
  let asked = false;
  let elsewhere = false;

  beforeEach(() => {
    storage = createStorage();
    asked = false;
    elsewhere = false;
  });

  /** A window that opens the project, as the page does it; with a program once there is one. */
  const openWindow = async () => {
    const { editor } = await openTestEditor(newProject('Test'));
    const guard = guardPreview(editor, { storage, asks: () => asked, isOpenElsewhere: async () => elsewhere });
    await openPath(editor, '/project');
    // Whatever it is: that there is one is what counts.
    editor.compile.setState({ program: {} as never });
    return { editor, leave: guard.leave };
  };
  const tell = (editor: Editor, state: PreviewStatus['state']) =>
    editor.preview.setState({ status: { state, frame: 0, timeS: 0 } as PreviewStatus });
  const stopped = (editor: Editor) => editor.preview.getState().stopped;

  test('runs where the last one ended as it should', async () => {
    const first = await openWindow();
    tell(first.editor, 'playing');
    expect(stopped(first.editor)).toBeNull();
    first.leave();
    expect(stopped((await openWindow()).editor)).toBeNull();
  });

  test('waits where the graphics device was lost, until it is started; then the next one runs', async () => {
    const first = await openWindow();
    tell(first.editor, 'playing');
    tell(first.editor, 'lost');
    first.leave();
    const second = await openWindow();
    expect(stopped(second.editor)).toBe('lost');
    second.leave();
    const third = await openWindow();
    expect(stopped(third.editor)).toBe('lost');
    startPreview(third.editor);
    tell(third.editor, 'playing');
    third.leave();
    expect(stopped((await openWindow()).editor)).toBeNull();
  });

  test('runs where the device came back by itself', async () => {
    const first = await openWindow();
    for (const state of ['playing', 'lost', 'playing'] as const) tell(first.editor, state);
    first.leave();
    expect(stopped((await openWindow()).editor)).toBeNull();
  });

  test('waits where the window ended without a word, but not for a window that shows the project still', async () => {
    const first = await openWindow();
    tell(first.editor, 'playing');
    expect(stopped((await openWindow()).editor)).toBe('broken-off');
    elsewhere = true;
    const other = await openWindow();
    await Promise.resolve();
    expect(stopped(other.editor)).toBeNull();
  });

  test('waits where the person asks for it, this once', async () => {
    asked = true;
    const first = await openWindow();
    expect(stopped(first.editor)).toBe('asked');
    first.leave();
    asked = false;
    expect(stopped((await openWindow()).editor)).toBeNull();
  });

  test('another project has nothing to do with it', async () => {
    const first = await openWindow();
    tell(first.editor, 'lost');
    first.leave();
    expect([...storage.values.keys()]).toEqual([expect.stringContaining('/project')]);
    const { editor } = await openWindow();
    expect(stopped(editor)).toBe('lost');
    editor.document.setState(({ open, project }) => ({
      open: open && { ...open, handle: 'other', displayPath: '/other' },
      project: { ...project },
    }));
    expect(stopped(editor)).toBeNull();
  });
});
