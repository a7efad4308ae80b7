import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import { undo } from '../document/apply.ts';
import { cancelDrag, undoOrCancelDrag } from '../document/cancel-drag.ts';
import { graphOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly, soleNode } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette, connect, toggleMuted } from '../graph/edit-graph.ts';
import { createSubgraph, openSubgraph, setPortExposed } from '../graph/subgraphs.ts';
import { bindExpression } from '../params/bind-params.ts';
import { editParam } from '../params/edit-params.ts';
import { toggleKey } from '../params/keyframes.ts';
import { createGizmoSync, currentGizmoTarget } from './apply-gizmo.ts';

function add(editor: Editor, type: string): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  if (id === null) throw new Error(`${type} was not added.`);
  return id;
}

/** A box that goes through two Transforms, side by side, into a scene. */
async function boxes() {
  const { editor } = await openTestEditor();
  const box = add(editor, 'objects/primitive');
  const [left, right] = [add(editor, 'objects/transform'), add(editor, 'objects/transform')];
  const scene = add(editor, 'layer/scene');
  for (const transform of [left, right]) {
    connect(editor, { node: box, port: 'objects' }, { node: transform, port: 'objects' });
    connect(editor, { node: transform, port: 'objects' }, { node: scene, port: 'objects' });
  }
  const posted: ToPreview[] = [];
  const gizmoSync = createGizmoSync(editor, (message) => posted.push(message));
  const shown = () => posted.filter((message) => message.kind === 'gizmo').at(-1)?.gizmo ?? null;
  let drags = 1;
  const drag = (values: Readonly<Record<string, number | readonly number[]>>, state: 'moved' | 'ended' = 'moved') => {
    gizmoSync.receive({ kind: 'gizmo', drag: drags, state, values });
    if (state === 'ended') drags++;
  };
  const nextDrag = () => drags++;
  return { editor, box, left, right, scene, gizmoSync, shown, drag, nextDrag, posted };
}

const position = (editor: Editor, node: string) => nodeOf(editor.document.getState(), node)?.params.positionM;

describe('what is taken hold of', () => {
  test('a Transform by its own place; a box by its own size, and by the place of what comes after it', async () => {
    const { editor, box, left, right, shown } = await boxes();
    selectOnly(editor.selection, [left]);
    const handles = { position: 'positionM', rotation: 'rotationRad', scale: 'scale' };
    expect(shown()).toMatchObject({ node: left, mode: 'move', space: 'world', handles });
    selectOnly(editor.selection, [box]);
    expect([left, right]).toContain(shown()?.node);
    editor.gizmo.setState({ mode: 'scale' });
    expect(shown()).toMatchObject({ node: box, handles: { scale: 'sizeM' } });
  });

  test('by the chain of the clicked object', async () => {
    const { editor, box, right, scene, gizmoSync, shown } = await boxes();
    gizmoSync.receive({ kind: 'picked', chain: [box, right, scene], phantom: false });
    expect(soleNode(editor.selection.getState())).toBe(box);
    expect(shown()).toMatchObject({ node: right, chain: [box, right, scene] });
    gizmoSync.receive({ kind: 'picked', chain: [box, right, scene], phantom: false });
    expect(soleNode(editor.selection.getState())).toBe(right);
  });

  test('not the surfaces that a device finds', async () => {
    const { editor, scene, gizmoSync } = await boxes();
    const planes = add(editor, 'world/planes');
    selectOnly(editor.selection, []);
    gizmoSync.receive({ kind: 'picked', chain: [planes, scene], phantom: true });
    expect(soleNode(editor.selection.getState())).toBe(null);
  });

  test('not what a wire or an expression decides, and it says so; muted Transforms are passed by', async () => {
    const { editor, left, right, box } = await boxes();
    selectOnly(editor.selection, [left]);
    bindExpression(editor, left, 'positionM', '[sin(time), 0, 0]');
    expect(currentGizmoTarget(editor, 'move')).toEqual({
      target: null,
      reason: '“Position” of Transform has an expression. Reset it to use the gizmo.',
    });
    expect(currentGizmoTarget(editor, 'rotate').target?.node).toBe(left);
    const vector = add(editor, 'value/make-vector3');
    connect(editor, { node: vector, port: 'vector' }, { node: right, port: 'positionM' });
    selectOnly(editor.selection, [right]);
    expect(currentGizmoTarget(editor, 'move')).toEqual({
      target: null,
      reason: '“Position” of Transform is connected. Disconnect it to use the gizmo.',
    });
    toggleMuted(editor);
    editor.gizmo.setState({ chain: [box, right] });
    expect(currentGizmoTarget(editor, 'move')).toMatchObject({ target: null, reason: expect.stringContaining('cannot be moved') });
  });

  test('copies by their spacing, or by their radius where they are in a ring; what is copied by itself', async () => {
    const { editor, box, left, scene, shown, drag, gizmoSync } = await boxes();
    const copies = add(editor, 'objects/copies');
    connect(editor, { node: left, port: 'objects' }, { node: copies, port: 'objects' });
    connect(editor, { node: copies, port: 'objects' }, { node: scene, port: 'objects' });
    selectOnly(editor.selection, [copies]);
    expect(shown()).toMatchObject({ node: copies, handles: { step: 'stepM' }, axes: 'xyz' });
    expect(currentGizmoTarget(editor, 'move')).toMatchObject({ target: { title: '“Spacing” of Array' } });
    expect(currentGizmoTarget(editor, 'rotate')).toMatchObject({ target: { handles: { turn: 'turnRad' }, axes: 'y' } });
    const before = editor.document.getState().project;
    drag({ stepM: [1, 0, 0] });
    drag({ stepM: [1, 0.2, 0] }, 'ended');
    expect(nodeOf(editor.document.getState(), copies)?.params).toEqual({ stepM: { value: [1, 0.2, 0] } });
    undo(editor);
    expect(editor.document.getState().project).toEqual(before);
    editParam(editor, copies, 'pattern', 'grid');
    expect(shown()).toMatchObject({ handles: { step: 'stepM' }, axes: 'xz' });
    editParam(editor, copies, 'pattern', 'ring');
    expect(shown()).toMatchObject({ handles: { radius: 'radiusM' }, axes: 'z' });
    expect(shown()?.handles).not.toHaveProperty('step');
    // The Array does not move what it copies.
    editor.gizmo.setState({ chain: [box, left, copies, scene] });
    selectOnly(editor.selection, [box]);
    expect(shown()).toMatchObject({ node: left });
    selectOnly(editor.selection, []);
    // A click on a copy selects the Array, further clicks what it copies.
    for (const next of [copies, box, left]) {
      gizmoSync.receive({ kind: 'picked', chain: [box, left, copies, scene], phantom: false });
      expect(soleNode(editor.selection.getState())).toBe(next);
    }
  });

  test('copies in a subgraph by their spacing, if their pattern has one', async () => {
    const { editor, shown } = await boxes();
    const copies = add(editor, 'objects/copies');
    selectOnly(editor.selection, [copies]);
    createSubgraph(editor);
    const [outer = ''] = editor.selection.getState().nodes;
    openSubgraph(editor, 'subgraph');
    for (const port of ['stepM', 'radiusM']) setPortExposed(editor, 'inputs', { node: copies, port }, true);
    const main = editor.document.getState().trail[0] ?? 'main';
    const leave = () => {
      editor.document.setState({ graph: main, trail: [] });
      selectOnly(editor.selection, [outer]);
    };
    leave();
    expect(shown()).toMatchObject({ node: `${outer}/${copies}`, handles: { step: 'stepM' } });
    openSubgraph(editor, 'subgraph');
    editParam(editor, copies, 'pattern', 'scatter');
    leave();
    expect(shown()).toMatchObject({ node: `${outer}/${copies}`, handles: { radius: 'radiusM' }, axes: 'z' });
  });

  test('filters by what they have in the image, in every mode; not where the center is connected', async () => {
    const { editor, shown, drag } = await boxes();
    const swirl = add(editor, 'filter/swirl');
    selectOnly(editor.selection, [swirl]);
    const handles = { center: 'center', extent: 'radius', angle: 'angle' };
    for (const mode of ['move', 'rotate', 'scale'] as const) {
      expect(currentGizmoTarget(editor, mode)).toMatchObject({ target: { handles, inImage: true } });
    }
    expect(shown()).toMatchObject({ node: swirl, handles });
    const before = editor.document.getState().project;
    drag({ center: [0.123456, 0.5] });
    drag({ center: [0.2, 1.5] }, 'ended');
    expect(nodeOf(editor.document.getState(), swirl)?.params).toEqual({ center: { value: [0.2, 1] } });
    expect(editor.document.getState().history.past.at(-1)?.label).toBe('Adjust Swirl');
    undo(editor);
    expect(editor.document.getState().project).toEqual(before);
    bindExpression(editor, swirl, 'radius', '100 + time');
    expect(shown()?.handles).toEqual({ center: 'center', angle: 'angle' });
    bindExpression(editor, swirl, 'center', '[time, 0.5]');
    expect(currentGizmoTarget(editor, 'move')).toEqual({
      target: null,
      reason: '“Center” of Swirl has an expression. Reset it to use the gizmo.',
    });
    selectOnly(editor.selection, [add(editor, 'layer/measure-mask')]);
    expect(shown()).toMatchObject({ handles: { low: 'regionMin', high: 'regionMax' } });
    const shape = add(editor, 'generator/shape-mask');
    selectOnly(editor.selection, [shape]);
    expect(shown()?.handles).toEqual({ center: 'center', size: 'size', angle: 'rotation', feather: 'feather' });
    for (const width of [0.6, 9]) drag({ size: [width, 0.5] }, width > 1 ? 'ended' : 'moved');
    expect(nodeOf(editor.document.getState(), shape)?.params).toEqual({ size: { value: [4, 0.5] } });
    undo(editor);
    expect(nodeOf(editor.document.getState(), shape)?.params).toEqual({});
  });

  test('poses by their position and rotation, which are not scaled and have no objects to connect', async () => {
    const { editor, shown } = await boxes();
    for (const [type, position] of [
      ['pose/from-values', 'positionM'],
      ['pose/offset', 'offsetM'],
    ] as const) {
      selectOnly(editor.selection, [add(editor, type)]);
      expect(shown()?.handles).toEqual({ position, rotation: 'rotationRad' });
    }
    expect(currentGizmoTarget(editor, 'scale')).toEqual({ target: null, reason: 'Offset pose cannot be scaled.' });
  });

  test('nothing where a node has no place, and of a model that goes nowhere what to do', async () => {
    const { editor } = await boxes();
    selectOnly(editor.selection, [add(editor, 'filter/sepia')]);
    expect(currentGizmoTarget(editor, 'move')).toEqual({ target: null, reason: null });
    selectOnly(editor.selection, [add(editor, 'source/model')]);
    expect(currentGizmoTarget(editor, 'move')).toMatchObject({
      reason: 'Model cannot be moved. Connect its objects to a Transform.',
    });
  });

  test('in a subgraph, and from outside by what it shows', async () => {
    const { editor, left, box, shown, drag } = await boxes();
    selectOnly(editor.selection, [box, left]);
    createSubgraph(editor);
    const [outer = ''] = editor.selection.getState().nodes;
    openSubgraph(editor, 'subgraph');
    selectOnly(editor.selection, [left]);
    expect(shown()).toMatchObject({ node: `${outer}/${left}` });
    setPortExposed(editor, 'inputs', { node: left, port: 'positionM' }, true);
    const { trail } = editor.document.getState();
    editor.document.setState({ graph: trail[0] ?? 'main', trail: [] });
    selectOnly(editor.selection, [outer]);
    expect(shown()).toMatchObject({ node: `${outer}/${left}`, handles: { position: 'positionM' } });
    drag({ positionM: [1, 0, 0] });
    drag({ positionM: [2, 0, 0] }, 'ended');
    const face = editor.document.getState().library.definition(nodeOf(editor.document.getState(), outer)?.type ?? '');
    const [name = ''] = Object.keys(face?.params ?? {});
    expect(nodeOf(editor.document.getState(), outer)?.params[name]).toEqual({ value: [2, 0, 0] });
  });
});

describe('a drag', () => {
  test('of an object without a Transform adds one to all its ways, as one step with the move', async () => {
    const { editor, scene, shown, drag } = await boxes();
    const model = add(editor, 'source/model');
    const phantom = add(editor, 'objects/phantom');
    for (const to of [scene, phantom]) connect(editor, { node: model, port: 'objects' }, { node: to, port: 'objects' });
    selectOnly(editor.selection, [model]);
    const before = editor.document.getState();
    expect(shown()).toMatchObject({ node: model, adds: true, mode: 'move', handles: { position: 'positionM' } });
    drag({ positionM: [0, 1, 0] });
    drag({ positionM: [0, 2, 0] }, 'ended');
    const known = Object.keys(graphOf(before).nodes);
    const [added = '', ...more] = Object.keys(graphOf(editor.document.getState()).nodes).filter((id) => !known.includes(id));
    expect(more).toEqual([]);
    expect(position(editor, added)).toEqual({ value: [0, 2, 0] });
    const { wires } = graphOf(editor.document.getState());
    expect(wires.filter(({ from }) => from.node === model).map(({ to }) => to.node)).toEqual([added]);
    expect(wires.filter(({ from }) => from.node === added).map(({ to }) => to.node)).toEqual(expect.arrayContaining([scene, phantom]));
    // The next drag moves the same Transform.
    expect(shown()).toMatchObject({ node: added });
    expect(shown()).not.toHaveProperty('adds');
    expect(soleNode(editor.selection.getState())).toBe(model);
    undo(editor);
    expect(editor.document.getState().project).toEqual(before.project);
  });

  test('adds no Transform to bodies, which the pointer throws', async () => {
    const { editor, scene } = await boxes();
    const body = add(editor, 'physics/body');
    const ball = add(editor, 'objects/primitive');
    connect(editor, { node: ball, port: 'objects' }, { node: body, port: 'objects' });
    connect(editor, { node: body, port: 'objects' }, { node: scene, port: 'objects' });
    for (const node of [ball, body]) {
      selectOnly(editor.selection, [node]);
      expect(currentGizmoTarget(editor, 'move')).toMatchObject({ target: null });
    }
  });

  test('that adds a Transform and is canceled leaves none', async () => {
    const { editor, scene, drag } = await boxes();
    const model = add(editor, 'source/model');
    connect(editor, { node: model, port: 'objects' }, { node: scene, port: 'objects' });
    selectOnly(editor.selection, [model]);
    const before = editor.document.getState().project;
    drag({ positionM: [0, 1, 0] });
    cancelDrag(editor);
    expect(editor.document.getState().project).toEqual(before);
  });

  test('is one step, rounded and within the param’s range, and the next is another', async () => {
    const { editor, left, drag } = await boxes();
    selectOnly(editor.selection, [left]);
    const before = filesOf(editor);
    drag({ positionM: [0.1, 0.2, 0.300000001] });
    drag({ positionM: [0.2, 0.2, 99] });
    drag({ positionM: [0.30000000000000004, 0.2, 99] }, 'ended');
    expect(position(editor, left)).toEqual({ value: [0.3, 0.2, 10] });
    drag({ positionM: [1, 0, 0] });
    drag({ positionM: [2, 0, 0] }, 'ended');
    undo(editor);
    expect(position(editor, left)).toEqual({ value: [0.3, 0.2, 10] });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('of two params is one step, too', async () => {
    const { editor, drag } = await boxes();
    const sun = add(editor, 'light/directional');
    selectOnly(editor.selection, [sun]);
    editor.gizmo.setState({ mode: 'rotate' });
    const before = filesOf(editor);
    drag({ azimuthRad: 1, elevationRad: 0.4 });
    drag({ azimuthRad: 1.2, elevationRad: 0.5 }, 'ended');
    expect(nodeOf(editor.document.getState(), sun)?.params).toEqual({ azimuthRad: { value: 1.2 }, elevationRad: { value: 0.5 } });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('taken back leaves no step, and what was done before can still be undone', async () => {
    const { editor, left, drag, nextDrag, shown } = await boxes();
    selectOnly(editor.selection, [left]);
    editParam(editor, left, 'scale', 2);
    const { past } = editor.document.getState().history;
    drag({ positionM: [1, 0, 0] });
    cancelDrag(editor);
    expect(position(editor, left)).toBeUndefined();
    expect(editor.document.getState().history.past.length).toBe(past.length);
    expect(editor.document.getState().history.future).toEqual([]);
    // What the preview holds on to is there again.
    expect(shown()).toMatchObject({ node: left });
    nextDrag();
    drag({ positionM: [1, 0, 0] });
    cancelDrag(editor);
    undo(editor);
    expect(nodeOf(editor.document.getState(), left)?.params.scale).toBeUndefined();
  });

  test('undone before the preview says that it ended stays undone, and the next drag counts', async () => {
    const { editor, left, drag } = await boxes();
    selectOnly(editor.selection, [left]);
    const before = filesOf(editor);
    drag({ positionM: [1, 0, 0] });
    undoOrCancelDrag(editor);
    drag({ positionM: [2, 0, 0] });
    drag({ positionM: [3, 0, 0] }, 'ended');
    expect(filesOf(editor)).toEqual(before);
    drag({ positionM: [4, 0, 0] });
    drag({ positionM: [4, 0, 1] }, 'ended');
    expect(position(editor, left)).toEqual({ value: [4, 0, 1] });
    undoOrCancelDrag(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('sets the key at the moment that is shown, where there are keyframes', async () => {
    const { editor, left, drag } = await boxes();
    selectOnly(editor.selection, [left]);
    toggleKey(editor, left, 'positionM', 0);
    const before = filesOf(editor);
    editor.preview.setState({
      status: {
        state: 'paused',
        frame: 30,
        timeS: 2,
        frameMs: 1,
        framesPerS: 0,
        widthPx: 1,
        heightPx: 1,
        request: 0,
        late: false,
        worldFromView: null,
        tangents: null,
      },
    });
    drag({ positionM: [1, 0, 0] });
    drag({ positionM: [2, 0, 0] }, 'ended');
    expect(position(editor, left)).toMatchObject({
      track: {
        keys: [
          { timeS: 0, value: [0, 0, 0] },
          { timeS: 2, value: [2, 0, 0] },
        ],
      },
    });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('of a node that goes away is over', async () => {
    const { editor, left, drag, shown } = await boxes();
    selectOnly(editor.selection, [left]);
    drag({ positionM: [1, 0, 0] });
    selectOnly(editor.selection, []);
    expect(shown()).toBe(null);
    expect(editor.gizmo.getState().drag).toBe(null);
    drag({ positionM: [3, 0, 0] }, 'ended');
    expect(position(editor, left)).toEqual({ value: [1, 0, 0] });
    expect(graphOf(editor.document.getState()).wires.length).toBe(4);
  });
});

test('keys pressed in the preview are for the editor, in the words of its shortcuts', async () => {
  const { editor, left, gizmoSync, posted } = await boxes();
  gizmoSync.sendAll();
  expect(posted.find(({ kind }) => kind === 'keys')).toMatchObject({ keybindings: expect.arrayContaining(['Mod+Z', 'W', 'E', 'S', 'X']) });
  selectOnly(editor.selection, [left]);
  gizmoSync.receive({ kind: 'key', keybinding: 'E' });
  expect(editor.gizmo.getState().mode).toBe('rotate');
  gizmoSync.receive({ kind: 'key', keybinding: 'E' });
  expect(editor.gizmo.getState().mode).toBe(null);
  editor.ui.setState({ dialog: { kind: 'commands' } });
  gizmoSync.receive({ kind: 'key', keybinding: 'W' });
  expect(editor.gizmo.getState().mode).toBe(null);
});
