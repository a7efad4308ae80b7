import { beforeEach, describe, expect, test } from '@jest/globals';
import { createCompiler } from '../../../export/compiler/compile.ts';
import type { Graph } from '../../../export/graph/project.ts';
import type { FakeHost } from '../../../tests/support/fake-host.ts';
import { LIBRARY } from '../../../tests/support/library.ts';
import { createSlowCompiler } from '../../../tests/support/slow-compiler.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import { undo } from '../document/apply.ts';
import { editShader, shaderOf } from '../document/edit-shader.ts';
import type { Editor } from '../editor/editor.ts';
import { isLoading } from '../editor/preview-state.ts';
import { selectOnly } from '../editor/selection.ts';
import { loadExternalChanges, openPath, saveAs } from '../files/files.ts';
import { addNodeFromPalette, connect } from '../graph/edit-graph.ts';
import { createSubgraph, leaveSubgraph, openSubgraph, setPortExposed } from '../graph/subgraphs.ts';
import { editParam } from '../params/edit-params.ts';
import { createPreviewSync, type PreviewSync } from './preview-sync.ts';

describe('the way from document to preview', () => {
  let editor: Editor;
  let host: FakeHost;
  let previewSync: PreviewSync;
  let sent: ToPreview[];
  let worker: ReturnType<typeof createSlowCompiler>;
  let blur: string;

  const add = (type: string) => {
    const definition = editor.document.getState().library.definition(type);
    const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
    if (!id) throw new Error(`${type} was not added.`);
    return id;
  };
  const takeTrials = () => {
    const messages = sent.splice(0);
    return { trials: messages.find((message) => message.kind === 'trials'), rest: messages };
  };
  const kinds = () => sent.splice(0).map((message) => (message.kind === 'param' ? `param ${message.value}` : message.kind));

  beforeEach(async () => {
    ({ editor, host } = await openTestEditor());
    worker = createSlowCompiler();
    previewSync = createPreviewSync(editor, worker.worker);
    sent = [];
    previewSync.attach((message) => void sent.push(message));
    const video = add('source/camera-video');
    blur = add('filter/gaussian-blur');
    const screen = add('output/screen');
    connect(editor, { node: video, port: 'layer' }, { node: blur, port: 'inputImage' });
    connect(editor, { node: blur, port: 'layer' }, { node: screen, port: 'layer' });
    while (worker.waiting.length > 0) worker.answer();
    sent = [];
  });

  test('a dial goes to the preview at once and asks for no program', () => {
    editParam(editor, blur, 'radius', 5);
    expect(kinds()).toEqual(['param 5']);
    expect(worker.waiting).toEqual([]);
  });

  test('values set while a program was being made are sent again after it', () => {
    const threshold = add('filter/threshold');
    connect(editor, { node: blur, port: 'layer' }, { node: threshold, port: 'inputImage' });
    editParam(editor, blur, 'radius', 5);
    editParam(editor, blur, 'radius', 6);
    expect(kinds()).toEqual(['param 5', 'param 6']);
    worker.answer();
    expect(kinds()).toEqual(['program', 'param 6']);
    worker.answer();
    expect(kinds()).toEqual(['program', 'param 6']);
    add('filter/sepia');
    worker.answer();
    expect(kinds()).toEqual(['program']);
  });

  test('a value that the program cannot follow asks for one that can, even where it came while another was being made', () => {
    // On the screen an `over` at full opacity is plain blending, and has no opacity to set.
    const over = add('operator/over');
    const video = add('source/camera-video');
    const screen = Object.entries(editor.document.getState().project.graphs.main?.nodes ?? {}).find(([, n]) => n.type === 'output/screen');
    connect(editor, { node: blur, port: 'layer' }, { node: over, port: 'top' });
    connect(editor, { node: video, port: 'layer' }, { node: over, port: 'bottom' });
    connect(editor, { node: over, port: 'layer' }, { node: screen?.[0] ?? '', port: 'layer' });
    while (worker.waiting.length > 0) worker.answer();
    expect(Object.keys(editor.compile.getState().program?.slots.params ?? {})).not.toContain(`${over}.opacity`);
    sent = [];

    editParam(editor, over, 'opacity', 0.5);
    expect(worker.waiting).toHaveLength(1);
    editParam(editor, over, 'opacity', 0.25);
    while (worker.waiting.length > 0) worker.answer();
    expect(kinds()).toEqual(['param 0.5', 'param 0.25', 'program', 'param 0.25', 'program']);
    expect(editor.compile.getState().laterValues).toEqual([]);
    editParam(editor, over, 'opacity', 0.75);
    expect(worker.waiting).toEqual([]);
    // Frames that are rendered from this program have to set it.
    expect(editor.compile.getState().laterValues).toMatchObject([{ node: over, param: 'opacity', value: 0.75 }]);

    // Full again, and a program is made of that; another value comes before it is there.
    editParam(editor, over, 'opacity', 1);
    add('filter/sepia');
    editParam(editor, over, 'opacity', 0.5);
    while (worker.waiting.length > 0) worker.answer();
    const { program } = editor.compile.getState();
    expect(program?.slots.numbers[program.slots.slots[program.slots.params[`${over}.opacity`] ?? -1]?.offset ?? -1]).toBe(0.5);
  });

  describe('within a subgraph', () => {
    /** What the program that is compiled afresh of the project begins with at the params that were sent. */
    const fresh = () => {
      const { layout: _, ...project } = editor.document.getState().project;
      const slots = createCompiler().compile({ project, library: LIBRARY }).output?.slots;
      return (address: string) => slots?.numbers[slots.slots[slots.params[address] ?? -1]?.offset ?? -1];
    };
    const expectFollowed = (addresses: readonly string[]) => {
      expect(worker.waiting).toEqual([]);
      const params = sent.splice(0).flatMap((message) => (message.kind === 'param' ? [message] : []));
      expect(params.map(({ node, param }) => `${node}.${param}`).sort()).toEqual([...addresses].sort());
      const valueAt = fresh();
      for (const { node, param, value } of params) expect(valueAt(`${node}.${param}`)).toBe(value);
    };
    const settle = () => {
      while (worker.waiting.length > 0) worker.answer();
      sent = [];
    };
    /** Blur within `subgraph`, which is used twice within `subgraph-2`, which the main graph uses twice. */
    const nest = () => {
      const state = () => editor.document.getState();
      selectOnly(editor.selection, [blur]);
      createSubgraph(editor);
      openSubgraph(editor, 'subgraph');
      setPortExposed(editor, 'inputs', { node: blur, port: 'radius' }, true);
      leaveSubgraph(editor);
      const first = selectedNode();
      const second = addUse('graph/subgraph', first);
      selectOnly(editor.selection, [first, second]);
      createSubgraph(editor);
      openSubgraph(editor, 'subgraph-2');
      setPortExposed(editor, 'inputs', { node: second, port: 'radius' }, true);
      leaveSubgraph(editor);
      const outer = selectedNode();
      const other = addUse('graph/subgraph-2', outer);
      settle();
      expect(state().graph).toBe('main');
      return { first, second, outer, other };
    };
    const selectedNode = () => {
      const [node = ''] = editor.selection.getState().nodes;
      return node;
    };
    /** Between the node and the screen. */
    const addUse = (type: string, before: string) => {
      const id = add(type);
      const { nodes } = editor.document.getState().project.graphs.main as Graph;
      const screen = Object.keys(nodes).find((node) => nodes[node]?.type === 'output/screen') ?? '';
      const [output = ''] = Object.keys(editor.document.getState().library.definition(type)?.outputs ?? {});
      const [input = ''] = Object.keys(editor.document.getState().library.definition(type)?.inputs ?? {});
      const from = (editor.document.getState().project.graphs.main as Graph).wires.find((wire) => wire.to.node === screen)?.from;
      expect(from?.node).toBe(before);
      connect(editor, from ?? { node: '', port: '' }, { node: id, port: input });
      connect(editor, { node: id, port: output }, { node: screen, port: 'layer' });
      return id;
    };

    test('a dial goes to each use of the subgraph, but where another value is set from outside, and asks for no program', () => {
      const { first, second, outer, other } = nest();
      const all = [outer, other].flatMap((use) => [`${use}/${first}/${blur}.radius`, `${use}/${second}/${blur}.radius`]);
      openSubgraph(editor, 'subgraph');
      for (const value of [5, 6]) {
        editParam(editor, blur, 'radius', value);
        expectFollowed(all);
      }
      leaveSubgraph(editor);

      editParam(editor, outer, 'radius', 9);
      expectFollowed([`${outer}/${second}/${blur}.radius`]);
      openSubgraph(editor, 'subgraph-2');
      editParam(editor, second, 'radius', 3);
      // What is set outside stays: `outer` keeps its 9.
      expectFollowed([outer, other].map((use) => `${use}/${second}/${blur}.radius`));
      leaveSubgraph(editor);
      undo(editor);
      expectFollowed([outer, other].map((use) => `${use}/${second}/${blur}.radius`));
      undo(editor);
      expectFollowed([`${outer}/${second}/${blur}.radius`]);
    });
  });

  test('a broken graph sends no program: what worked plays on, and a page that comes anew is given it', () => {
    const program = editor.compile.getState().program;
    editShader(editor, blur, (shaderOf(editor.document.getState(), blur)?.text ?? '').replace('void main', 'void 0main'));
    worker.answer();
    expect(kinds()).toEqual(['trials']);
    expect(editor.compile.getState().diagnostics.some(({ severity }) => severity === 'error')).toBe(true);
    expect(editor.compile.getState().program).toBe(program);
    previewSync.receive({ kind: 'ready' });
    expect(kinds()).toEqual([
      'render-size',
      'physics',
      'physics-view',
      'program',
      'trials',
      'thumbnails',
      'viewer',
      'cost',
      'gizmo',
      'picking',
      'keys',
    ]);
  });

  test('the preview counts as loading from the moment another source is chosen until it is there', () => {
    const status = {
      state: 'playing',
      frame: 1,
      late: false,
      timeS: 0,
      frameMs: 1,
      framesPerS: 0,
      widthPx: 1,
      heightPx: 1,
      worldFromView: null,
      tangents: null,
    } as const;
    const tell = (request: number | null) => previewSync.receive({ kind: 'status', status: { ...status, request } });
    const loading = () => isLoading(editor.preview.getState());
    previewSync.receive({ kind: 'ready' });
    previewSync.receive({ kind: 'playing', revision: 1 });
    editor.preview.setState({ sourceId: 'orbit' });
    expect(sent.filter(({ kind }) => kind === 'session')).toMatchObject([{ request: 1, source: { kind: 'orbit' } }]);
    tell(null);
    expect(loading()).toBe(true);
    tell(1);
    expect(loading()).toBe(false);
    // A status that was on its way when the next was chosen is about the one before.
    editor.preview.setState({ sourceId: 'camera' });
    tell(1);
    expect(loading()).toBe(true);
    tell(2);
    expect(loading()).toBe(false);
    // What an emulated device looks like is nothing to this source.
    editor.preview.setState({ views: 2 });
    expect(sent.filter(({ kind }) => kind === 'session')).toHaveLength(2);
    expect(loading()).toBe(false);
  });

  test('what the driver said is told on the author’s lines, of the newest program alone', () => {
    const { program, programRevision } = editor.compile.getState();
    const shader = program?.shaders.find(({ sourceMap }) => sourceMap?.sources.includes('filters/gaussian-blur.fs'));
    const line = (shader?.sourceMap?.lines.findIndex((entry) => entry !== null) ?? -1) + 1;
    if (!shader || programRevision === null || line === 0) throw new Error('The blur has no shader in the program.');
    const errors = [{ shaderId: shader.id, stage: 'fragment' as const, log: `ERROR: 0:${line}: 'x' : undeclared identifier` }];
    previewSync.receive({ kind: 'shader-errors', revision: programRevision - 1, errors });
    expect(editor.preview.getState().shaderDiagnostics).toEqual([]);
    previewSync.receive({ kind: 'shader-errors', revision: programRevision, errors });
    expect(editor.preview.getState().shaderDiagnostics).toMatchObject([
      { code: 'SCR042', nodeId: blur, file: 'filters/gaussian-blur.fs', line: shader.sourceMap?.lines[line - 1]?.[1] },
    ]);
  });

  test('without a program, the driver is asked about the text above the mistake, and what it says of the rest does not count', () => {
    const state = editor.document.getState();
    const text = shaderOf(state, blur)?.text ?? '';
    const lines = text.split('\n').length;
    editShader(editor, blur, `${text}float above() { return missing; }\nfloat below( { }\n`);
    worker.answer();
    expect(editor.compile.getState().diagnostics).toMatchObject([{ code: 'SCR041', nodeId: blur, line: lines + 1 }]);
    const { trials, rest } = takeTrials();
    expect(rest).not.toContainEqual(expect.objectContaining({ kind: 'program' }));
    const shader = trials?.shaders.find(({ fragment }) => fragment.includes('missing'));
    const printed = (word: string) => (shader?.fragment.split('\n').findIndex((line) => line.includes(word)) ?? -1) + 1;
    const log = [`ERROR: 0:${printed('missing')}: 'missing' : undeclared identifier`, `ERROR: 0:1: 'x' : undeclared identifier`].join('\n');
    const errors = [{ shaderId: shader?.id ?? '', stage: 'fragment' as const, log }];
    const revision = trials?.revision ?? 0;
    previewSync.receive({ kind: 'trial-errors', revision: revision - 1, errors });
    expect(editor.preview.getState().shaderDiagnostics).toEqual([]);
    previewSync.receive({ kind: 'trial-errors', revision, errors });
    const said = { code: 'SCR042', nodeId: blur, file: 'shaders/gaussian-blur-2.fs', line: lines, column: 24 };
    expect(editor.preview.getState().shaderDiagnostics).toMatchObject([said]);

    // A preview page that is loaded again is asked again.
    previewSync.receive({ kind: 'ready' });
    expect(takeTrials().trials?.revision).toBe(revision);
    // The mistake above stays marked until the driver has seen the next text.
    editShader(editor, blur, `${text}float above() { return 1.0; }\nfloat below( { }\n`);
    worker.answer();
    expect(editor.preview.getState().shaderDiagnostics).toMatchObject([said]);
    previewSync.receive({ kind: 'trial-errors', revision: takeTrials().trials?.revision ?? 0, errors: [] });
    expect(editor.preview.getState().shaderDiagnostics).toEqual([]);
    // Where nothing stands above, there is nothing to ask.
    editShader(editor, blur, text.replace('*/', '*/\nfloat first( {}'));
    worker.answer();
    expect(takeTrials().trials).toBeUndefined();
  });

  test('another project starts with nothing of the one before', async () => {
    editParam(editor, blur, 'radius', 5);
    await openPath(editor, '/project');
    expect(editor.compile.getState().program).toBeNull();
    expect(editor.preview.getState().playing).toBeNull();
  });

  test('the picture of another project goes at once and comes with its program; one that goes on keeps its picture', async () => {
    const isForeign = () => editor.preview.getState().foreign;
    const play = () => previewSync.receive({ kind: 'playing', revision: editor.document.getState().revision });
    play();
    for (const goOn of [() => openPath(editor, '/project'), () => loadExternalChanges(editor), () => saveAs(editor, '/copy', 'Copy')]) {
      await goOn();
      expect(isForeign()).toBe(false);
    }
    await openPath(editor, '/other');
    expect(isForeign()).toBe(true);
    await openPath(editor, '/other');
    expect(isForeign()).toBe(true);
    play();
    expect(isForeign()).toBe(false);
  });

  test('the preview reads files where the project is now, whatever it takes its picture from', async () => {
    const listed = { id: 'example/walk', title: 'A walk', kind: 'recorded', url: 'http://127.0.0.1:1/sessions/walk/' } as const;
    host.answer('session.list', () => [listed]);
    previewSync.receive({ kind: 'ready' });
    for (const sourceId of ['example/walk', 'orbit']) {
      editor.preview.setState({ sourceId });
      for (const goOn of [() => openPath(editor, '/other'), () => saveAs(editor, '/copy', 'Copy'), () => loadExternalChanges(editor)]) {
        await goOn();
        const source = sent.flatMap((message) => (message.kind === 'session' ? message.source : [])).at(-1);
        expect(source).toMatchObject({
          kind: sourceId === 'orbit' ? 'orbit' : 'recorded',
          assetBaseUrl: editor.document.getState().open?.assetBaseUrl,
        });
      }
    }
  });

  test('another project is not shown what was still being made of the one before', async () => {
    editShader(editor, blur, `${shaderOf(editor.document.getState(), blur)?.text}\nvoid broken(`);
    const { revision } = editor.document.getState();
    await openPath(editor, '/project');
    const own = worker.waiting.length;
    sent = [];
    worker.answer();
    previewSync.receive({ kind: 'playing', revision });
    expect([own, editor.compile.getState().diagnostics, editor.compile.getState().busy]).toEqual([1, [], true]);
    expect(editor.preview.getState().playing).toBeNull();
    worker.answer();
    expect(editor.compile.getState().busy).toBe(false);
    expect(editor.compile.getState().revision).toBe(editor.document.getState().revision);
  });
});
