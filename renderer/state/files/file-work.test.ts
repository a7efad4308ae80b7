import { describe, expect, test } from '@jest/globals';
import { setTitle } from '../../../export/graph/commands/project-info.ts';
import { newProject } from '../../../export/graph/new-project.ts';
import { saveProject } from '../../../export/graph/save.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { copySelection, parseClipping } from '../clipboard/clipboard.ts';
import { apply } from '../document/apply.ts';
import { isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { autosave, handleHostEvents } from '../start.ts';
import { addFiles } from './add-files.ts';
import { breakLockAndSave, openPath, openProject, save, saveAs } from './files.ts';

function retitle(editor: Editor, title: string): void {
  apply(editor, 'Title', setTitle(editor.document.getState().project, { title }));
}

/** An editor whose host saves as the real one does: only over the revision that it was last told of, and each when it is let. */
async function openSlowly() {
  const opened = await openTestEditor();
  const { editor, host } = opened;
  const held: (() => void)[] = [];
  const revisions: string[] = [];
  let count = 0;
  host.answer('project.save', async ({ files, revision }) => {
    revisions.push(revision);
    await new Promise<void>((resolve) => held.push(resolve));
    host.writeOutside(files);
    return { revision: `saved${++count}`, kept: null };
  });
  const letGo = async () => {
    while (held.length === 0) await Promise.resolve();
    held.shift()?.();
  };
  const handlesOf = (method: string) =>
    host.calls.flatMap((call) => (call.method === method ? (call.input as { handle: string }).handle : []));
  return { ...opened, letGo, revisions, handleNow: () => editor.document.getState().open?.handle ?? '', handlesOf };
}

describe('work on files, one thing after the other', () => {
  test('a second save waits for the first, and builds on what that wrote', async () => {
    const { editor, letGo, revisions } = await openSlowly();
    retitle(editor, 'A');
    const first = save(editor);
    const second = save(editor);
    await letGo();
    expect(await first).toBe(true);
    await letGo();
    expect(await second).toBe(true);
    // With the same revision twice, the host would have told of somebody else's change.
    expect(revisions).toEqual(['r1', 'saved1']);
    expect(editor.ui.getState().dialog).toBeNull();
    expect(isDirty(editor.document.getState())).toBe(false);
  });

  test('a save that ends late says nothing of the project that is open by then', async () => {
    const { editor, letGo, revisions } = await openSlowly();
    retitle(editor, 'A');
    const saved = save(editor);
    const other = openPath(editor, '/other');
    await letGo();
    await Promise.all([saved, other]);
    expect(editor.document.getState().open?.displayPath).toBe('/other');
    expect(isDirty(editor.document.getState())).toBe(false);
    retitle(editor, 'B');
    const again = save(editor);
    await letGo();
    expect(await again).toBe(true);
    expect(revisions[1]).not.toBe('saved1');
  });

  test('of two projects that are opened at once the last stays, and every other one is closed once', async () => {
    const { editor, handleNow, handlesOf } = await openSlowly();
    await Promise.all([openPath(editor, '/a'), openPath(editor, '/b')]);
    expect(editor.document.getState().open?.displayPath).toBe('/b');
    const all = ['1', '2', '3'].map((number) => `abcdef0123456789${number}`);
    expect(handlesOf('project.close').sort()).toEqual(all.filter((handle) => handle !== handleNow()));
  });

  test('a project is opened, and its sources are listed, also where the one before cannot be closed', async () => {
    const { editor, host, handleNow } = await openSlowly();
    host.refuse('project.close', 'SCR073', 'The project is no longer open.');
    expect(await openPath(editor, '/other')).toBe(true);
    expect(host.calls.at(-1)).toEqual({ method: 'session.list', input: { handle: handleNow() } });
  });

  test('a copy is gone on with, also where the original cannot be closed', async () => {
    const { editor, host } = await openSlowly();
    retitle(editor, 'A');
    host.refuse('project.autosave', 'SCR060', 'The folder cannot be written.');
    expect(await saveAs(editor, '/copy', 'Copy')).toBe(true);
    expect(editor.document.getState().open?.displayPath).toBe('/copy');
    expect(isDirty(editor.document.getState())).toBe(false);
  });

  test('what is typed at the moment counts as unsaved', async () => {
    const { editor } = await openSlowly();
    const finish = () => {
      editor.unfinished.delete(finish);
      retitle(editor, 'Typed');
    };
    editor.unfinished.add(finish);
    openProject(editor);
    expect(editor.ui.getState().dialog?.kind).toBe('unsaved');
  });

  test('unsaved work of each project is kept, however many steps the one before had', async () => {
    const { editor, clock, handlesOf, handleNow } = await openSlowly();
    const stop = autosave(editor);
    retitle(editor, 'A');
    clock.pass(2000);
    await openPath(editor, '/other');
    retitle(editor, 'B');
    clock.pass(2000);
    expect(handlesOf('project.autosave').at(-1)).toBe(handleNow());
    stop();
  });

  test('unsaved work is kept at least every five seconds, also of somebody who never pauses', async () => {
    const { editor, clock, host } = await openSlowly();
    const stop = autosave(editor);
    let keptAtStep = 0;
    let longest = 0;
    host.answer('project.autosave', ({ files }) => {
      keptAtStep = Number((JSON.parse(files?.project ?? '{}') as { title: string }).title);
      return {};
    });
    const stepMs = 500;
    for (let step = 1; step <= 80; step++) {
      retitle(editor, String(step));
      clock.pass(stepMs);
      await Promise.resolve();
      longest = Math.max(longest, (step - keptAtStep) * stepMs);
    }
    expect(longest).toBeLessThanOrEqual(5000);
    stop();
  });

  test('a save that meets a lock offers to break it, and then saves', async () => {
    const { editor, host } = await openTestEditor();
    retitle(editor, 'A');
    host.refuse('project.save', 'SCR066', 'Another Scrim is writing this project.');
    expect(await save(editor)).toBe(false);
    expect(editor.ui.getState().dialog).toEqual({ kind: 'locked', overwrite: false });
    expect(await breakLockAndSave(editor, false)).toBe(true);
    expect(host.calls.slice(-2).map(({ method }) => method)).toEqual(['project.break-lock', 'project.save']);
    expect(isDirty(editor.document.getState())).toBe(false);
  });

  test('a file that is dropped goes into the project that it was dropped on', async () => {
    const { editor, host } = await openSlowly();
    const into: string[] = [];
    let arrive = () => {};
    host.answer('asset.import', async ({ handle, name }) => {
      into.push(handle);
      await new Promise<void>((resolve) => {
        arrive = resolve;
      });
      return { path: `assets/${name}` };
    });
    const file = { name: 'robot.glb', arrayBuffer: async () => new ArrayBuffer(4) };
    const { handle } = editor.document.getState().open ?? {};
    const added = addFiles(editor, [file], { x: 0, y: 0 });
    const opened = openPath(editor, '/other');
    while (into.length === 0) await Promise.resolve();
    expect(editor.document.getState().open?.handle).toBe(handle);
    arrive();
    await added;
    expect(into).toEqual([handle]);
    await opened;
    expect(Object.keys(editor.document.getState().project.assets)).toEqual([]);
  });

  test('what was copied last stays on the clipboard, however long the files of an earlier clipping take', async () => {
    const { editor, host } = await openSlowly();
    const file = { name: 'robot.glb', arrayBuffer: async () => new ArrayBuffer(4) };
    await addFiles(editor, [file], { x: 0, y: 0 });
    let arrive = () => {};
    host.answer('asset.read', async () => {
      await new Promise<void>((resolve) => {
        arrive = resolve;
      });
      return { base64: '' };
    });
    const slow = copySelection(editor);
    const definition = editor.document.getState().library.definition('filter/sepia');
    if (!definition) throw new Error('There is no sepia.');
    const sepia = addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    await copySelection(editor);
    arrive();
    await slow;
    expect(Object.keys(parseClipping(await editor.clipboard.read())?.nodes ?? {})).toEqual([sepia]);
  });

  test('the window closes, also where the disk keeps work that was given up', async () => {
    const { editor, host } = await openSlowly();
    const stop = handleHostEvents(editor);
    host.writeOutside(saveProject(newProject('Test')));
    host.refuse('project.autosave', 'SCR060', 'The folder cannot be written.');
    host.emit({ kind: 'close-requested' });
    for (let turn = 0; turn < 10; turn++) await Promise.resolve();
    expect(host.calls.at(-1)?.method).toBe('app.close');
    stop();
  });
});
