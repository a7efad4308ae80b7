import { expect, test } from '@jest/globals';
import { printWire } from '../../../export/graph/wires.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { clipSelection, duplicateSelection, parseClipping } from '../clipboard/clipboard.ts';
import { undo } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemId } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { connectPorts, reconnectPorts, refusalOfEnds } from './connect-ports.ts';
import { addNodeFromPalette, connect, deleteSelection } from './edit-graph.ts';
import { dropOnWire } from './insert-on-wire.ts';
import { addReroute } from './reroutes.ts';

function add(editor: Editor, type: string, x: number): string {
  const definition = editor.document.getState().library.definition(type);
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x, y: 0 }, null) : null;
  if (id === null) throw new Error(`There is no ${type}.`);
  return id;
}

const wiresOf = (editor: Editor) => graphOf(editor.document.getState()).wires.map(printWire);
const routesOf = (editor: Editor) => layoutOf(editor.document.getState()).routes;

/** A picture's way to two nodes, through `trunk`. */
async function fan() {
  const { editor } = await openTestEditor();
  const [video, sepia, blur] = [
    add(editor, 'source/camera-video', 0),
    add(editor, 'filter/sepia', 400),
    add(editor, 'filter/gaussian-blur', 400),
  ];
  connect(editor, { node: video, port: 'layer' }, { node: sepia, port: 'inputImage' });
  const [toSepia = ''] = wiresOf(editor);
  const trunk = addReroute(editor, toSepia, { x: 200, y: 40 }) ?? '';
  connectPorts(editor, { node: itemId('reroute', trunk), port: 'knob' }, { node: blur, port: 'inputImage' });
  const toBlur = `${video}.layer -> ${blur}.inputImage`;
  return { editor, video, sepia, blur, trunk, toSepia, toBlur, shared: `${video}.layer via nothing to ${trunk}` };
}

test('what is put into the shared way of wires is in the way of all of them, and each goes on as it went', async () => {
  const { editor, video, trunk, shared, toSepia, toBlur } = await fan();
  expect(routesOf(editor)).toEqual({ [toSepia]: [trunk], [toBlur]: [trunk] });
  const first = addReroute(editor, shared, { x: 100, y: 40 }) ?? '';
  expect(routesOf(editor)).toEqual({ [toSepia]: [first, trunk], [toBlur]: [first, trunk] });
  const before = filesOf(editor);
  const node = add(editor, 'filter/pixelate', 900);
  expect(dropOnWire(editor, node, { x: 150, y: 0 }, `${video}.layer via ${first} to ${trunk}`)).toBe(true);
  expect(routesOf(editor)).toEqual({
    [`${video}.layer -> ${node}.inputImage`]: [first],
    [toSepia.replace(video, node)]: [trunk],
    [toBlur.replace(video, node)]: [trunk],
  });
  undo(editor);
  undo(editor);
  expect(filesOf(editor)).toEqual(before);
});

test('a wire brought to a point is what all after it come from; one that would come round to itself is refused', async () => {
  const { editor, trunk, sepia, toSepia, toBlur, video } = await fan();
  const other = add(editor, 'source/camera-video', 0);
  const point = { node: itemId('reroute', trunk), port: 'in' };
  expect(refusalOfEnds(editor, { node: sepia, port: 'layer' }, point)?.code).toBe('SCR014');
  expect(refusalOfEnds(editor, { ...point, port: 'knob' }, point)?.code).toBe('SCR014');
  connectPorts(editor, { node: other, port: 'layer' }, point);
  expect(routesOf(editor)).toEqual({ [toSepia.replace(video, other)]: [trunk], [toBlur.replace(video, other)]: [trunk] });
  expect(wiresOf(editor).filter((wire) => wire.startsWith(video))).toEqual([]);
});

test('an end that is moved keeps the way there is, and takes none that is not its own', async () => {
  const { editor, trunk, toSepia, toBlur, video, blur } = await fan();
  const pixelate = add(editor, 'filter/pixelate', 400);
  reconnectPorts(editor, toSepia, { node: itemId('reroute', trunk), port: 'through' }, { node: pixelate, port: 'inputImage' });
  expect(routesOf(editor)).toEqual({ [toBlur]: [trunk], [`${video}.layer -> ${pixelate}.inputImage`]: [trunk] });
  const other = add(editor, 'source/camera-video', 0);
  reconnectPorts(editor, toBlur, { node: other, port: 'layer' }, { node: blur, port: 'inputImage' });
  expect(Object.keys(routesOf(editor))).toEqual([`${video}.layer -> ${pixelate}.inputImage`]);
});

test('copies are led through copies, as text too; wires that come in from elsewhere leave the old way at its last point', async () => {
  const { editor, video, sepia, blur, trunk, toSepia, toBlur } = await fan();
  selectOnly(editor.selection, [sepia]);
  duplicateSelection(editor, { wired: true });
  expect(Object.values(routesOf(editor))).toEqual([[trunk], [trunk], [trunk]]);
  undo(editor);
  selectOnly(editor.selection, [video, sepia]);
  const clipping = clipSelection(editor);
  expect(Object.keys(clipping?.ways?.routes ?? {})).toEqual([toSepia]);
  expect(parseClipping(JSON.stringify(clipping))).toEqual(clipping);
  expect(parseClipping(JSON.stringify({ ...clipping, ways: { reroutes: { [trunk]: { x: 'far' } }, routes: {} } }))).toBeNull();
  duplicateSelection(editor);
  const { [toSepia]: _, [toBlur]: __, ...copied } = routesOf(editor);
  const [copy = ''] = Object.values(copied).flat();
  // The point keeps its place between the copies, which cover none of the nodes.
  const { nodes, reroutes } = layoutOf(editor.document.getState());
  const [videoCopy = '', sepiaCopy = ''] = [...editor.selection.getState().nodes].sort((a, b) => (nodes[a]?.x ?? 0) - (nodes[b]?.x ?? 0));
  const offset = (from?: Place, to?: Place) => ({ x: (to?.x ?? 0) - (from?.x ?? 0), y: (to?.y ?? 0) - (from?.y ?? 0) });
  expect(offset(nodes[videoCopy], reroutes[copy])).toEqual(offset(nodes[video], reroutes[trunk]));
  expect(offset(nodes[sepiaCopy], reroutes[copy])).toEqual(offset(nodes[sepia], reroutes[trunk]));
  expect(nodes[videoCopy]?.x).toBe((nodes[video]?.x ?? 0) + 32);
  const lowest = Math.max(...[video, sepia, blur].map((id) => nodes[id]?.y ?? 0));
  expect(Math.min(nodes[videoCopy]?.y ?? 0, nodes[sepiaCopy]?.y ?? 0)).toBeGreaterThan(lowest + 40);
  expect(editor.selection.getState().items).toEqual(new Set([itemId('reroute', copy)]));
});

test('deleted, a point leaves its wires; with the last of its wires it goes itself', async () => {
  const { editor, sepia, blur, trunk, toSepia, toBlur } = await fan();
  selectOnly(editor.selection, [], [], [itemId('reroute', trunk)]);
  deleteSelection(editor);
  expect(routesOf(editor)).toEqual({});
  expect(wiresOf(editor).sort()).toEqual([toSepia, toBlur].sort());
  undo(editor);
  selectOnly(editor.selection, [sepia]);
  deleteSelection(editor);
  expect(routesOf(editor)).toEqual({ [toBlur]: [trunk] });
  selectOnly(editor.selection, [blur]);
  deleteSelection(editor);
  expect(layoutOf(editor.document.getState()).reroutes).toEqual({});
});
