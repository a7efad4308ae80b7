import { describe, expect, test } from '@jest/globals';
import type { HostInput } from '../../../app/contract/contract.ts';
import { setTitle } from '../../../export/graph/commands/project-info.ts';
import { newProject } from '../../../export/graph/new-project.ts';
import { saveProject } from '../../../export/graph/save.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { apply } from '../document/apply.ts';
import { graphOf, isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { autosave, handleHostEvents } from '../start.ts';
import { addFiles } from './add-files.ts';
import { createProject, openPath, openProject, openSaveAs, reload, save, saveAs } from './files.ts';

function retitle(editor: Editor, title: string): void {
  apply(editor, 'Title', setTitle(editor.document.getState().project, { title }));
}

/** What the editor has asked its host for has come and been worked in. */
function settle(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
}

describe('files', () => {
  test('a save over someone else’s change asks, and can go ahead', async () => {
    const { editor, host } = await openTestEditor();
    retitle(editor, 'Mine');
    host.refuse('project.save', 'SCR063', 'Changed.');
    expect(await save(editor)).toBe(false);
    expect(editor.ui.getState().dialog).toEqual({ kind: 'changed-outside' });
    expect(await save(editor, true)).toBe(true);
    expect(host.calls.at(-1)?.input).toMatchObject({ overwrite: true });
  });

  test('other refusals are shown with their words', async () => {
    const { editor, host } = await openTestEditor();
    host.refuse('project.save', 'SCR060', 'The folder cannot be written.');
    expect(await save(editor)).toBe(false);
    expect(editor.ui.getState().toasts.map(({ text }) => text)).toEqual(['The folder cannot be written.']);
  });

  test('a project that cannot be read leaves the open one alone', async () => {
    const { editor, host } = await openTestEditor();
    retitle(editor, 'Kept');
    host.refuse('project.open', 'SCR004', 'There is no project.');
    expect(await openPath(editor, '/nowhere')).toBe(false);
    expect(editor.document.getState().project.title).toBe('Kept');
  });

  test('opening another project asks about unsaved work first', async () => {
    const { editor } = await openTestEditor();
    openProject(editor);
    expect(editor.ui.getState().dialog?.kind).toBe('open');
    editor.ui.setState({ dialog: null });
    retitle(editor, 'Mine');
    openProject(editor);
    const { dialog } = editor.ui.getState();
    expect(dialog?.kind).toBe('unsaved');
    if (dialog?.kind === 'unsaved') dialog.proceed();
    expect(editor.ui.getState().dialog?.kind).toBe('open');
  });

  test('a new project takes the place of the open one, whose unsaved work is forgotten once it was given up', async () => {
    const { editor, host } = await openTestEditor();
    const before = editor.document.getState().open?.handle;
    retitle(editor, 'Given up');
    expect(await createProject(editor, { path: '/new', template: 'empty', title: 'New one' })).toBe(true);
    expect(host.calls.find(({ method }) => method === 'project.create')?.input).toEqual({
      path: '/new',
      template: 'empty',
      title: 'New one',
    });
    expect(editor.document.getState().open?.displayPath).toBe('/new');
    const rest = host.calls.slice(-3).map(({ method, input }) => [method, input]);
    expect(rest).toEqual([
      ['project.autosave', { handle: before, files: null }],
      ['project.close', { handle: before }],
      ['session.list', { handle: editor.document.getState().open?.handle }],
    ]);
  });

  test('work that is not given up is not forgotten: a folder that cannot be opened changes nothing', async () => {
    const { editor, host } = await openTestEditor();
    retitle(editor, 'Kept');
    host.refuse('project.create', 'SCR061', 'The folder is not empty.');
    expect(await createProject(editor, { path: '/full', template: 'empty' })).toBe(false);
    expect(editor.document.getState().project.title).toBe('Kept');
    expect(host.calls.some(({ method }) => method === 'project.autosave' || method === 'project.close')).toBe(false);
    expect(editor.ui.getState().toasts.map(({ text }) => text)).toEqual(['The folder is not empty.']);
  });

  test('a project that another window shows is opened with a word of warning', async () => {
    const { editor } = await openTestEditor(undefined, { openElsewhere: true });
    expect(editor.ui.getState().toasts.map(({ tone, text }) => [tone, text])).toEqual([
      ['warning', 'This project is also open in another window.'],
    ]);
  });

  test('a copy has the name that was typed, and the original keeps its own', async () => {
    const { editor, host } = await openTestEditor();
    expect(await saveAs(editor, '/copy', 'Test copy')).toBe(true);
    const call = host.calls.find(({ method }) => method === 'project.save-as')?.input as HostInput<'project.save-as'>;
    expect(JSON.parse(call.files.project)).toMatchObject({ title: 'Test copy' });
    const state = editor.document.getState();
    expect([state.project.title, state.open?.displayPath, isDirty(state)]).toEqual(['Test copy', '/copy', false]);
    expect(editor.preferences.getState().recent[0]).toEqual({ path: '/copy', title: 'Test copy' });
  });

  test('a copy that cannot be written changes nothing, and the dialog says why', async () => {
    const { editor, host } = await openTestEditor();
    openSaveAs(editor);
    host.refuse('project.save-as', 'SCR061', '/full is not empty.');
    expect(await saveAs(editor, '/full', 'Test copy')).toBe(false);
    const { dialog, dialogErrors, toasts } = editor.ui.getState();
    expect([dialog, toasts]).toEqual([{ kind: 'save-as' }, []]);
    expect(dialogErrors.map(({ text }) => text)).toEqual(['/full is not empty.']);
    expect(editor.document.getState().project.title).toBe('Test');
    expect(editor.document.getState().history.past).toEqual([]);
    editor.ui.setState({ dialog: null });
    expect(editor.ui.getState().dialogErrors).toEqual([]);
  });

  test('each error of an opening stands in the dialog, until the next attempt', async () => {
    const { editor, host } = await openTestEditor();
    openProject(editor);
    const broken = { project: '{', layout: null, sources: {} };
    host.answer('project.open', () => ({ ...opened, files: broken }));
    const opened = await host.call('project.create', { path: '/x', template: 'empty' });
    expect(await openPath(editor, '/broken')).toBe(false);
    expect(editor.ui.getState().dialogErrors).toHaveLength(1);
    host.refuse('project.open', 'SCR004', '/nowhere does not exist.');
    expect(await openPath(editor, '/nowhere')).toBe(false);
    expect(editor.ui.getState().dialogErrors.map(({ text }) => text)).toEqual(['/nowhere does not exist.']);
    expect(editor.ui.getState().toasts).toEqual([]);
  });

  test('reload takes the version on disk and forgets the unsaved one', async () => {
    const { editor, host } = await openTestEditor();
    retitle(editor, 'Mine');
    expect(await reload(editor)).toBe(true);
    expect(editor.document.getState().project.title).toBe('Test');
    expect(host.calls.some(({ method, input }) => method === 'project.autosave' && (input as { files: unknown }).files === null)).toBe(
      true,
    );
  });

  test('unsaved work is kept after a pause, once', async () => {
    const { editor, host, clock } = await openTestEditor();
    autosave(editor);
    retitle(editor, 'A');
    clock.pass(500);
    retitle(editor, 'B');
    clock.pass(2000);
    clock.pass(2000);
    const kept = host.calls.filter(({ method }) => method === 'project.autosave');
    expect(kept).toHaveLength(1);
    expect(JSON.stringify(kept[0]?.input)).toContain('\\"B\\"');
  });

  test('the window closes at once when all is saved, and asks when not', async () => {
    const { editor, host } = await openTestEditor();
    handleHostEvents(editor);
    retitle(editor, 'Mine');
    host.emit({ kind: 'close-requested' });
    expect(editor.ui.getState().dialog?.kind).toBe('unsaved');
    expect(host.calls.some(({ method }) => method === 'app.close')).toBe(false);
    await save(editor);
    host.emit({ kind: 'close-requested' });
    await Promise.resolve();
    await new Promise((resolve) => setTimeout(resolve, 0));
    expect(host.calls.at(-1)?.method).toBe('app.close');
  });

  test('a change on disk is taken over where nothing is unsaved', async () => {
    const { editor, host } = await openTestEditor();
    handleHostEvents(editor);
    const { handle = '' } = editor.document.getState().open ?? {};
    host.writeOutside(saveProject(newProject('Theirs')));
    host.emit({ kind: 'project-changed-outside', handle, revision: 'r2' });
    await settle();
    expect(editor.document.getState().project.title).toBe('Theirs');
    expect(editor.ui.getState().dialog).toBeNull();
    // What the preview plays lies at the address of the new opening.
    const now = editor.document.getState().open?.handle;
    expect(host.calls.slice(-2)).toEqual([
      { method: 'project.close', input: { handle } },
      { method: 'session.list', input: { handle: now } },
    ]);
  });

  test('a change on disk asks where something is unsaved, typed or done while the files were read', async () => {
    for (const when of ['before', 'typed', 'meanwhile'] as const) {
      const { editor, host } = await openTestEditor();
      handleHostEvents(editor);
      const { handle = '' } = editor.document.getState().open ?? {};
      host.writeOutside(saveProject(newProject('Theirs')));
      if (when === 'before') retitle(editor, 'Mine');
      if (when === 'typed') {
        const finish = () => {
          editor.unfinished.delete(finish);
          retitle(editor, 'Mine');
        };
        editor.unfinished.add(finish);
      }
      host.emit({ kind: 'project-changed-outside', handle, revision: 'r2' });
      if (when === 'meanwhile') retitle(editor, 'Mine');
      await settle();
      expect([when, editor.document.getState().project.title]).toEqual([when, 'Mine']);
      expect([when, editor.ui.getState().dialog?.kind]).toEqual([when, 'changed-outside']);
      // Nothing was lost: the person takes one version or the other.
      expect(await reload(editor)).toBe(true);
      expect(editor.document.getState().project.title).toBe('Theirs');
    }
  });

  test('a change on disk that is no project leaves the canvas alone, and says what is wrong', async () => {
    const { editor, host } = await openTestEditor();
    handleHostEvents(editor);
    const { handle = '' } = editor.document.getState().open ?? {};
    host.writeOutside({ project: '{ "half', layout: null, sources: {} });
    host.emit({ kind: 'project-changed-outside', handle, revision: 'r2' });
    await settle();
    expect(editor.document.getState().project.title).toBe('Test');
    expect(editor.document.getState().open?.handle).toBe(handle);
    expect(editor.ui.getState().toasts.map(({ tone }) => tone)).toContain('error');
  });

  test('a shader that is dropped with its pictures finds them in the project', async () => {
    const { editor, host } = await openTestEditor();
    const file = (name: string, text = '') => ({ name, arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer });
    const isf = `/*{"IMPORTED":{
      "grain":{"PATH":"pics/Grain 1.PNG"}, "other":{"PATH":"other.jpg"},
      "sky":{"TYPE":"cube","PATH":["a.png","b.png","c.png","d.png","e.png","f.png"]}
    }}*/
void main() { gl_FragColor = IMG_THIS_PIXEL(grain); }
`;
    await addFiles(editor, [file('a.png'), file('leak.fs', isf), file('grain 1.png'), file('mine.png')], { x: 0, y: 0 });
    const { project } = editor.document.getState();
    expect(project.sources['leak.fs']).toBe(
      isf.replace('pics/Grain 1.PNG', '../assets/grain 1.png').replace('"a.png"', '"../assets/a.png"'),
    );
    expect(host.calls.flatMap(({ method, input }) => (method === 'asset.import' ? [(input as { name: string }).name] : []))).toEqual([
      'grain 1.png',
      'a.png',
      'mine.png',
    ]);
    // What no shader asks for is a picture in the graph, as ever.
    const types = Object.values(graphOf(editor.document.getState()).nodes).map(({ type }) => type);
    expect(types.sort()).toEqual(['generator/leak', 'source/image-file']);
  });

  test('dropped files become assets, shaders and nodes; what cannot be used is named', async () => {
    const { editor } = await openTestEditor();
    const file = (name: string, text = '') => ({ name, arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer });
    const isf =
      '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }\n';
    await addFiles(editor, [file('robot.glb'), file('glow.fs', isf), file('notes.txt')], { x: 0, y: 0 });
    const { project } = editor.document.getState();
    const [asset] = Object.entries(project.assets);
    expect(asset?.[1]).toEqual({ path: 'assets/robot.glb', kind: 'model' });
    const nodes = Object.values(graphOf(editor.document.getState()).nodes);
    expect(nodes.map(({ type }) => type).sort()).toEqual(['filter/glow', 'source/model']);
    expect(nodes.find(({ type }) => type === 'source/model')?.params.model).toEqual({ value: asset?.[0] });
    expect(project.sources['glow.fs']).toBe(isf);
    expect(editor.ui.getState().toasts.at(-1)?.text).toContain('notes.txt');
  });

  test('a shader brings the vertex shader of its name along, and gets a name that a node can have', async () => {
    const { editor } = await openTestEditor();
    const file = (name: string, text = '') => ({ name, arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer });
    const isf =
      '/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/\nvarying vec2 left;\nvoid main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, left); }';
    const vertex = 'varying vec2 left;\nvoid main() { isf_vertShaderInit(); left = isf_FragNormCoord; }';
    await addFiles(editor, [file('Glow+More!.vs', vertex), file('Glow+More!.fs', isf), file('alone.vs', vertex)], { x: 0, y: 0 });
    const { project } = editor.document.getState();
    expect(project.sources).toEqual({ 'glow-more.fs': isf, 'glow-more.vs': vertex });
    expect(Object.values(project.graphs.main?.nodes ?? {}).map(({ type }) => type)).toContain('filter/glow-more');
    expect(editor.ui.getState().toasts.map(({ text }) => text)).toEqual([
      expect.stringContaining('alone.vs is a vertex shader without its ISF file'),
    ]);
  });
});
