import { beforeEach, describe, expect, test } from '@jest/globals';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect as connectCommand } from '../../../export/graph/commands/wire-commands.ts';
import type { Program } from '../../../export/program/program.ts';
import { createSlowCompiler } from '../../../tests/support/slow-compiler.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { candidateOf } from '../graph/palette-candidates.ts';
import { editParam } from '../params/edit-params.ts';
import { toggleSavedVersion } from '../preview/saved-version.ts';
import { createPreviewSync, type PreviewSync } from './preview-sync.ts';

describe('a candidate, which the pointer rests on,', () => {
  let editor: Editor;
  let previewSync: PreviewSync;
  let sent: ToPreview[];
  let worker: ReturnType<typeof createSlowCompiler>;
  let blur: string;
  let screen: string;

  const add = (type: string) => {
    const id = addNodeFromPalette(editor, entryOf(type), { x: 0, y: 0 }, null);
    if (!id) throw new Error(`${type} was not added.`);
    return id;
  };

  beforeEach(async () => {
    ({ editor } = await openTestEditor());
    worker = createSlowCompiler();
    previewSync = createPreviewSync(editor, worker.worker);
    sent = [];
    previewSync.attach((message) => void sent.push(message));
    const video = add('source/camera-video');
    blur = add('filter/gaussian-blur');
    screen = add('output/screen');
    connect(editor, { node: video, port: 'layer' }, { node: blur, port: 'inputImage' });
    connect(editor, { node: blur, port: 'layer' }, { node: screen, port: 'layer' });
    while (worker.waiting.length > 0) worker.answer();
    sent = [];
  });

  const entryOf = (type: string) => {
    const definition = editor.document.getState().library.definition(type);
    if (!definition) throw new Error(`There is no ${type}.`);
    return { definition, port: null };
  };
  const point = (type: string) => editor.candidate.setState({ project: candidateOf(editor, entryOf(type), {}) });
  const leave = () => editor.candidate.setState({ project: null });
  /** The nodes of each program that was sent since the last call. */
  const drawn = () => sent.splice(0).flatMap((message) => (message.kind === 'program' ? [namesIn(message.program)] : []));
  const namesIn = ({ operations }: Program) => [...new Set(operations.map(({ node }) => node.replace(/-\w{4}$/, '')))].join();
  const usual = 'camera-video,gaussian-blur';

  test('is shown, and the document again when the pointer leaves, without a trace', () => {
    editParam(editor, blur, 'radius', 5);
    const { history, project, revision } = editor.document.getState();
    const { diagnostics, busy } = editor.compile.getState();
    sent = [];
    point('filter/sepia');
    worker.answer();
    expect(drawn()).toEqual([`${usual},sepia`]);
    previewSync.receive({ kind: 'playing', revision: -1 });
    previewSync.receive({ kind: 'diagnostics', revision: -1, diagnostics: [{ code: 'SCR050', severity: 'error', message: 'No.' }] });
    leave();
    const [restored, ...later] = sent;
    expect(restored).toMatchObject({ kind: 'program', revision: editor.compile.getState().programRevision });
    // What was set after the compile is set again.
    expect(later).toEqual([{ kind: 'param', node: blur, param: 'radius', value: 5 }]);
    expect(editor.document.getState()).toMatchObject({ history, project, revision });
    expect(editor.compile.getState()).toMatchObject({ diagnostics, busy });
    expect(editor.preview.getState().diagnostics).toEqual([]);
    expect(editor.preview.getState().playing).not.toBe(-1);
  });

  test('is left out when the pointer is gone before it is compiled, or over the next entry', () => {
    point('filter/sepia');
    point('filter/vignette');
    worker.answer();
    expect(drawn()).toEqual([]);
    worker.answer();
    expect(drawn()).toEqual([`${usual},vignette`]);
    point('filter/sepia');
    leave();
    expect(drawn()).toEqual([usual]);
    worker.answer();
    expect(drawn()).toEqual([]);
  });

  test('stays until the program of the choice is there', () => {
    point('filter/sepia');
    worker.answer();
    expect(drawn()).toEqual([`${usual},sepia`]);
    addNodeFromPalette(editor, entryOf('filter/sepia'), { x: 0, y: 0 }, null, `${blur}.layer -> ${screen}.layer`);
    expect(editor.candidate.getState().project).toBeNull();
    expect(drawn()).toEqual([]);
    worker.answer();
    expect(drawn()).toEqual([`${usual},sepia`]);
  });

  test('does not hold up a change of the document', () => {
    add('filter/sepia');
    const sepia = add('filter/vignette');
    point('filter/sepia');
    connect(editor, { node: blur, port: 'layer' }, { node: sepia, port: 'inputImage' });
    while (worker.waiting.length > 0) worker.answer();
    expect(editor.compile.getState()).toMatchObject({ busy: false, revision: editor.document.getState().revision });
  });

  test('is not shown if it needs more of the device, or does not fit', () => {
    for (const type of ['objects/primitive', 'value/number']) expect([type, candidateOf(editor, entryOf(type), {})]).toEqual([type, null]);
    const { project, graph, library } = editor.document.getState();
    const added = addNode(project, { library, graph, id: 'sound-aaaa', type: 'source/microphone', x: 0, y: 0 });
    const ends = { from: { node: 'sound-aaaa', port: 'level' }, to: { node: blur, port: 'radius' } };
    const wired = connectCommand(added.project, { library, graph, ...ends });
    expect(wired.diagnostics).toEqual([]);
    editor.candidate.setState({ project: wired.project });
    worker.answer();
    expect(drawn()).toEqual([]);
  });

  test('can be the saved version', () => {
    add('filter/sepia');
    while (worker.waiting.length > 0) worker.answer();
    sent = [];
    toggleSavedVersion(editor);
    expect(Object.keys(editor.candidate.getState().project?.graphs.main?.nodes ?? { none: 0 })).toEqual([]);
    toggleSavedVersion(editor);
    expect(editor.candidate.getState().project).toBeNull();
  });
});
