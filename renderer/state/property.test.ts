import { expect, test } from '@jest/globals';
import fc from 'fast-check';
import type { PortAddress } from '../../export/graph/project.ts';
import { stretchesOf } from '../../export/graph/routes.ts';
import { openTestEditor } from '../../tests/support/test-editor.ts';
import { clipSelection, duplicateSelection, pasteClipping } from './clipboard/clipboard.ts';
import { endGesture, redo, undo } from './document/apply.ts';
import { addVertex, canAddVertex, editShader, removeVertex, shaderOf } from './document/edit-shader.ts';
import { graphOf, layoutOf, nodeOf } from './editor/document.ts';
import type { Editor } from './editor/editor.ts';
import { itemId, itemIds } from './editor/item-ids.ts';
import { selectOnly } from './editor/selection.ts';
import { filesOf } from './files/files.ts';
import { align, distribute } from './graph/arrange.ts';
import { connectPorts, refusalOfEnds } from './graph/connect-ports.ts';
import {
  addNodeFromPalette,
  connect,
  deleteSelection,
  removeWires,
  selectAll,
  swapType,
  toggleCollapsed,
  toggleMuted,
} from './graph/edit-graph.ts';
import { dropOnWire } from './graph/insert-on-wire.ts';
import { addFrame, addNote, contentOf, editItemText, moveAll, resizeItem } from './graph/layout-items.ts';
import { addReroute, addRerouteToSelected } from './graph/reroutes.ts';
import {
  createSubgraph,
  leaveSubgraph,
  makeUnique,
  openSubgraph,
  renameSubgraph,
  setPortExposed,
  ungroupSelected,
} from './graph/subgraphs.ts';
import { bindExpression, unbind } from './params/bind-params.ts';
import { editParam, resetParam, setExposed } from './params/edit-params.ts';
import { animatedParams, setEasing, toggleKey } from './params/keyframes.ts';

const TYPES = [
  'source/camera-video',
  'filter/sepia',
  'filter/gaussian-blur',
  'filter/curves',
  'operator/over',
  'value/math',
  'objects/primitive',
  'layer/scene',
];
const TRIES = 6;

interface Hand {
  readonly editor: Editor;
  /** Picks by dice from what is there at the time; undefined where nothing is. */
  of<T>(items: readonly T[]): T | undefined;
  node(): string;
}

function handOf(editor: Editor, dice: readonly number[]): Hand {
  let at = 0;
  const of = <T>(items: readonly T[]) => items[Math.floor((dice[at++ % dice.length] ?? 0) * items.length)];
  return { editor, of, node: () => of(Object.keys(graphOf(editor.document.getState()).nodes)) ?? '' };
}

function portOf({ editor, of }: Hand, node: string, side: 'inputs' | 'outputs' | 'params'): string {
  const state = editor.document.getState();
  return of(Object.keys(state.library.definition(nodeOf(state, node)?.type ?? '')?.[side] ?? {})) ?? '';
}

function wireIn({ editor, of }: Hand): string {
  const wire = of(graphOf(editor.document.getState()).wires);
  return wire ? `${wire.from.node}.${wire.from.port} -> ${wire.to.node}.${wire.to.port}` : '';
}

/** Somewhere that a wire may go to: few pairs of ports fit. */
function endFor({ editor, of }: Hand, from: PortAddress): PortAddress | undefined {
  const state = editor.document.getState();
  const ports = Object.entries(graphOf(state).nodes).flatMap(([node, { type }]) => {
    const { inputs = {}, params = {} } = state.library.definition(type) ?? {};
    return Object.keys({ ...inputs, ...params }).map((port) => ({ node, port }));
  });
  const reroutes = itemIds(layoutOf(state)).map((node) => ({ node, port: 'in' }));
  return of([...ports, ...reroutes].filter((to) => refusalOfEnds(editor, from, to) === null));
}

function stretchIn({ editor, of }: Hand): string {
  const state = editor.document.getState();
  return of([...stretchesOf(graphOf(state), layoutOf(state)).keys()]) ?? '';
}

/** As the canvas calls it. */
function rerouteIn({ editor, of }: Hand): string {
  return itemId('reroute', of(Object.keys(layoutOf(editor.document.getState()).reroutes)) ?? 'none');
}

/** What people do, each as the page calls it. */
const ACTIONS: Readonly<Record<string, (hand: Hand) => void>> = {
  add: ({ editor, of }) => {
    const definition = editor.document.getState().library.definition(of(TYPES) ?? '');
    if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: of([0, 3.5, 700]) ?? 0, y: -0.2 }, null);
  },
  wire: (hand) => {
    const node = hand.node();
    const from = { node, port: portOf(hand, node, 'outputs') };
    const to = endFor(hand, from);
    if (to) connect(hand.editor, from, to);
  },
  unwire: (hand) => void removeWires(hand.editor, [wireIn(hand)]),
  select: (hand) => selectOnly(hand.editor.selection, [hand.node(), hand.node()]),
  selectAll: ({ editor }) => selectAll(editor),
  selectOne: (hand) => selectOnly(hand.editor.selection, [hand.node()]),
  move: (hand) => void moveAll(hand.editor, { [hand.node()]: { x: hand.of([8, -40, 3.3]) ?? 0, y: -0.4 } }),
  drop: (hand) => void dropOnWire(hand.editor, hand.node(), { x: 1, y: 2 }, stretchIn(hand)),
  delete: ({ editor }) => void deleteSelection(editor),
  mute: ({ editor }) => void toggleMuted(editor),
  collapse: ({ editor }) => void toggleCollapsed(editor),
  swap: ({ editor, node, of }) => void swapType(editor, node(), of(TYPES) ?? ''),
  align: ({ editor, of }) => void align(editor, of(['left', 'middle', 'right'] as const) ?? 'left'),
  distribute: ({ editor }) => void distribute(editor, 'y'),
  set: (hand) => {
    const node = hand.node();
    editParam(hand.editor, node, portOf(hand, node, 'params'), hand.of([0, 0.5, -0, true, 'add', [1, 0, 0, 1], 1e9]) ?? 0);
    endGesture(hand.editor);
  },
  key: (hand) => {
    // Few params are numbers.
    for (let tries = 0; tries < TRIES; tries++) {
      const node = hand.node();
      if (toggleKey(hand.editor, node, portOf(hand, node, 'params'), hand.of([0, 0.5, 2]) ?? 0)) return;
    }
  },
  ease: ({ editor, of }) => {
    const { node, param } = of(animatedParams(editor.document.getState())) ?? { node: '', param: '' };
    for (const y of [0.2, of([1.5, -0.4]) ?? 0]) setEasing(editor, node, param, 0, [0.3, y, 0.6, 1]);
    endGesture(editor);
  },
  /** A point is added and dragged, as one gesture. */
  draw: (hand) => {
    const node = Object.entries(graphOf(hand.editor.document.getState()).nodes).find(([, { type }]) => type === 'filter/curves')?.[0] ?? '';
    const param = hand.of(['all', 'red', 'luma']) ?? 'all';
    for (const y of [0.5, hand.of([0.7, 0.2]) ?? 0]) editParam(hand.editor, node, param, [0, 0, 0.5, y, 1, 1]);
    endGesture(hand.editor);
  },
  bind: (hand) => {
    // Few params are numbers.
    for (let tries = 0; tries < TRIES; tries++) {
      const node = hand.node();
      if (bindExpression(hand.editor, node, portOf(hand, node, 'params'), hand.of(['time', 'sin(time) * 2', '1 +']) ?? 'time')) return;
    }
  },
  unbind: ({ editor, of }) => {
    const bound = Object.entries(graphOf(editor.document.getState()).nodes).flatMap(([id, { params }]) =>
      Object.entries(params).flatMap(([param, binding]) => ('expression' in binding ? [[id, param] as const] : [])),
    );
    const [node, param] = of(bound) ?? ['', ''];
    unbind(editor, node, param);
  },
  reset: (hand) => {
    const node = hand.node();
    resetParam(hand.editor, node, portOf(hand, node, 'params'));
  },
  expose: (hand) => {
    const node = hand.node();
    setExposed(hand.editor, node, portOf(hand, node, 'params'), hand.of([true, false]) ?? true);
  },
  duplicate: ({ editor, of }) => void duplicateSelection(editor, { wired: of([true, false]) ?? true }),
  paste: ({ editor }) => {
    const clipping = clipSelection(editor);
    if (clipping) pasteClipping(editor, clipping, 'Paste', { x: 32, y: 32 });
  },
  shader: ({ editor, node }) => {
    const id = node();
    const shader = shaderOf(editor.document.getState(), id);
    if (shader) editShader(editor, id, `${shader.text}\n// mine`);
    endGesture(editor);
  },
  vertex: ({ editor, node }) => {
    const id = node();
    if (canAddVertex(editor.document.getState(), id)) addVertex(editor, id);
    else removeVertex(editor, id);
  },
  pack: ({ editor }) => void createSubgraph(editor),
  unpack: ({ editor }) => void ungroupSelected(editor),
  independent: ({ editor }) => void makeUnique(editor),
  enter: ({ editor, of }) =>
    openSubgraph(editor, of(Object.keys(editor.document.getState().project.graphs).filter((name) => name !== 'main')) ?? ''),
  leave: ({ editor }) => leaveSubgraph(editor),
  rename: ({ editor, of }) => {
    const name = of(Object.keys(editor.document.getState().project.graphs).filter((graph) => graph !== 'main'));
    if (name !== undefined) renameSubgraph(editor, name, of(['Look', 'FrameRender grain', '!']) ?? 'Look');
  },
  show: (hand) => {
    ACTIONS.enter?.(hand);
    const node = hand.node();
    const side = hand.of(['inputs', 'outputs'] as const) ?? 'inputs';
    setPortExposed(hand.editor, side, { node, port: portOf(hand, node, side) }, hand.of([true, true, false]) ?? true);
    leaveSubgraph(hand.editor);
  },
  frame: ({ editor }) => void addFrame(editor, { x: 10.4, y: -0.2 }),
  note: ({ editor }) => void addNote(editor, { x: -0.2, y: 3 }),
  write: ({ editor, of }) => {
    editItemText(editor, of(itemIds(layoutOf(editor.document.getState()))) ?? '', of(['Water', 'a\nb', '']) ?? '');
    endGesture(editor);
  },
  resize: ({ editor, of }) => {
    const id = of(itemIds(layoutOf(editor.document.getState()))) ?? '';
    resizeItem(editor, id, { x: 1.5, y: of([2, -30]) ?? 0, width: 300, height: 200.5 });
  },
  moveFrame: ({ editor, of }) => {
    const id = of(itemIds(layoutOf(editor.document.getState()))) ?? '';
    moveAll(editor, { ...contentOf(editor, id), [id]: { x: of([5, 50.5]) ?? 0, y: 6 } });
  },
  reroute: (hand) => void addReroute(hand.editor, stretchIn(hand), { x: hand.of([0.5, 300]) ?? 0, y: -0.2 }),
  rerouteByKey: (hand) => {
    selectOnly(hand.editor.selection, [], [wireIn(hand)]);
    addRerouteToSelected(hand.editor);
  },
  branch: (hand) => {
    const from = { node: rerouteIn(hand), port: 'knob' };
    const to = endFor(hand, from);
    if (to) connectPorts(hand.editor, from, to);
  },
  moveReroute: (hand) => void moveAll(hand.editor, { [rerouteIn(hand)]: { x: hand.of([5, 50.5]) ?? 0, y: 6 } }),
  selectReroute: (hand) => selectOnly(hand.editor.selection, [hand.node()], [], [rerouteIn(hand)]),
  undo: ({ editor }) => undo(editor),
  redo: ({ editor }) => redo(editor),
};

test('whatever people do, undoing all of it gives the same bytes back, and redoing it the same again', async () => {
  const done = new Set<string>();
  const dice = fc.array(fc.double({ min: 0, max: 0.999, noNaN: true }), { minLength: 12, maxLength: 12 });
  const steps = fc.array(fc.tuple(fc.constantFrom(...Object.keys(ACTIONS)), dice), { minLength: 20, maxLength: 60, size: 'max' });
  await fc.assert(
    fc.asyncProperty(steps, async (sequence) => {
      const { editor } = await openTestEditor();
      for (const [i, type] of TYPES.entries()) {
        const definition = editor.document.getState().library.definition(type);
        if (definition) addNodeFromPalette(editor, { definition, port: null }, { x: 200 * i, y: 30 * i * i }, null);
      }
      const idOf = (type: string) =>
        Object.entries(graphOf(editor.document.getState()).nodes).find(([, node]) => node.type === type)?.[0] ?? '';
      connect(editor, { node: idOf('filter/sepia'), port: 'layer' }, { node: idOf('filter/gaussian-blur'), port: 'inputImage' });
      for (const [name, thrown] of sequence) {
        const before = editor.document.getState().revision;
        ACTIONS[name]?.(handOf(editor, thrown));
        if (editor.document.getState().revision !== before) done.add(name);
      }
      const { history } = editor.document.getState();
      const steps = history.past.length;
      const after = filesOf(editor);
      for (let step = 0; step < steps; step++) undo(editor);
      expect(filesOf(editor)).toEqual(filesOf((await openTestEditor()).editor));
      expect(editor.document.getState().graph).toBe('main');
      for (let step = 0; step < steps; step++) redo(editor);
      expect(filesOf(editor)).toEqual(after);
    }),
    { seed: 3, numRuns: 120 },
  );
  // An action that was always refused would prove nothing; these change no project.
  const idle = ['selectReroute', 'select', 'selectAll', 'selectOne', 'enter', 'leave'];
  expect(Object.keys(ACTIONS).filter((name) => !done.has(name) && !idle.includes(name))).toEqual([]);
});
