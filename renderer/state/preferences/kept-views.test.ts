import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import { openTestEditor, type TestEditor } from '../../../tests/support/test-editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { createProject, openPath } from '../files/files.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { createSubgraph, openSubgraph } from '../graph/subgraphs.ts';
import { keepViews } from './kept-views.ts';

const VIDEO = { type: 'source/camera-video', version: 1, params: {} };
const TIMES = { timesS: [0, 0.1, 0.2, 0.3], durationS: 0.4 };

function memory(): Pick<Storage, 'getItem' | 'setItem'> {
  const texts = new Map<string, string>();
  return { getItem: (key) => texts.get(key) ?? null, setItem: (key, text) => void texts.set(key, text) };
}

/** Opens the project again, as a later visit does. */
async function openAgain({ editor }: TestEditor): Promise<void> {
  editor.document.setState({ open: null });
  await openPath(editor, '/project');
}

test('the first open shows the whole graph; later ones open graph, view and selection as they were left', async () => {
  const opened = await openTestEditor({
    ...newProject('Test'),
    graphs: { main: { nodes: { 'video-aaaa': VIDEO }, wires: [], exposed: { inputs: [], outputs: [] } } },
  });
  const { editor, clock } = opened;
  const stop = keepViews(editor, memory());
  await openAgain(opened);
  expect(editor.ui.getState().reveal).toMatchObject({ nodes: [], how: 'fit' });

  const place = { x: 120, y: -40, zoom: 1.5 };
  selectOnly(editor.selection, ['video-aaaa', 'gone-aaaa']);
  editor.canvas.setState({ shown: place });
  clock.pass(1000);
  await openAgain(opened);
  expect(editor.ui.getState().reveal?.how).toEqual(place);
  // A node that is gone is not selected.
  expect([...editor.selection.getState().nodes]).toEqual(['video-aaaa']);
  stop();
});

test('a subgraph that was open opens again; without it, the main graph', async () => {
  const opened = await openTestEditor();
  const { editor, clock } = opened;
  const storage = memory();
  const stop = keepViews(editor, storage);
  await openAgain(opened);
  const definition = editor.document.getState().library.definition('filter/sepia');
  const id = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  selectOnly(editor.selection, [id ?? '']);
  createSubgraph(editor);
  openSubgraph(editor, 'subgraph');
  clock.pass(1000);
  // The subgraph was not saved.
  await openAgain(opened);
  expect(editor.document.getState()).toMatchObject({ graph: 'main', trail: [] });
  expect(editor.ui.getState().reveal?.how).toBe('fit');
  stop();
});

test('a recording stands at its first frame when a project opens for the first time; other sources, and projects that were left so, play', async () => {
  const opened = await openTestEditor();
  const { editor, clock } = opened;
  const posted: unknown[] = [];
  editor.transport.post = (message) => void posted.push(message);
  const stop = keepViews(editor, memory());
  /** The project opens while the preview has the state of the project before, `before`. */
  const load = async (state: 'paused' | 'playing', frames: typeof TIMES | null, before = state) => {
    const statusOf = (its: typeof state) => ({ state: its, frame: 3, timeS: 0.3, request: 1, late: false }) as never;
    editor.preview.setState({ playing: null, status: statusOf(before) });
    await openAgain(opened);
    posted.length = 0;
    const status = statusOf(state);
    const session = { id: 'room', title: 'Room', kind: 'recorded', url: '' } as const;
    editor.preview.setState({ sources: [session], frames, playing: 1, request: 1, status });
    return [...posted];
  };
  expect(await load('playing', TIMES)).toEqual([
    { kind: 'transport', action: 'pause' },
    { kind: 'seek', timeS: 0 },
  ]);
  // It is paused, and then left playing.
  for (const state of ['paused', 'playing']) {
    editor.preview.setState({ asked: null, status: { ...(editor.preview.getState().status as object), state } as never });
  }
  clock.pass(1000);
  expect(await load('playing', TIMES)).toEqual([]);
  expect(await load('paused', TIMES)).toEqual([{ kind: 'transport', action: 'play' }]);
  // A pause while the project loads stays.
  expect(await load('paused', TIMES, 'playing')).toEqual([]);
  stop();
  const stopNew = keepViews(editor, memory());
  expect(await load('paused', null)).toEqual([{ kind: 'transport', action: 'play' }]);
  // Choosing a recording afterwards does not pause it.
  posted.length = 0;
  editor.preview.setState({ frames: TIMES });
  expect(posted).toEqual([]);
  stopNew();
});

test('a paused recording stands at its frame again when it is loaded', async () => {
  const opened = await openTestEditor();
  const { editor, clock } = opened;
  const posted: unknown[] = [];
  editor.transport.post = (message) => void posted.push(message);
  const stop = keepViews(editor, memory());
  await openAgain(opened);
  const session = { id: 'room', title: 'Room', kind: 'recorded', url: '' } as const;
  const status = { state: 'paused', frame: 2, timeS: 0.2, request: 1, late: false } as never;
  editor.preview.setState({ sources: [session], frames: TIMES, playing: 1, request: 1, status });
  editor.preview.setState({ asked: null });
  clock.pass(1000);
  posted.length = 0;

  editor.preview.setState({ frames: null, status: null });
  await openAgain(opened);
  expect(posted).toEqual([]);
  editor.preview.setState({ sources: [session], frames: TIMES, status: { ...(status as object), state: 'playing', frame: 0 } as never });
  expect(posted).toEqual([
    { kind: 'transport', action: 'pause' },
    { kind: 'seek', timeS: 0.2 },
  ]);
  stop();
});

test('a new project in the folder of an earlier one opens as for the first time', async () => {
  const { editor, clock } = await openTestEditor();
  const stop = keepViews(editor, memory());
  const place = { x: 120, y: -40, zoom: 1.5 };
  await openPath(editor, '/reused');
  editor.canvas.setState({ shown: place });
  clock.pass(1000);
  await openPath(editor, '/project');
  await openPath(editor, '/reused');
  expect(editor.ui.getState().reveal?.how).toEqual(place);
  await openPath(editor, '/project');
  const posted: unknown[] = [];
  editor.transport.post = (message) => void posted.push(message);
  await createProject(editor, { path: '/reused', template: 'empty' });
  expect(editor.ui.getState().reveal).toMatchObject({ nodes: [], how: 'fit' });
  const session = { id: 'room', title: 'Room', kind: 'recorded', url: '' } as const;
  const status = { state: 'playing', frame: 3, timeS: 0.3, request: 1, late: false } as never;
  editor.preview.setState({ sources: [session], frames: TIMES, playing: 1, request: 1, status });
  expect(posted).toEqual([
    { kind: 'transport', action: 'pause' },
    { kind: 'seek', timeS: 0 },
  ]);
  stop();
});
