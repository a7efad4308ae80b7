import { isShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { removeNodes } from '../../../export/graph/commands/node-commands.ts';
import { putReroute, setRoutes } from '../../../export/graph/commands/route-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeLayoutId, makeNodeId } from '../../../export/graph/document-names.ts';
import { screensOf } from '../../../export/graph/liveness.ts';
import { type GraphNode, MAIN_GRAPH, type NodeLayout, type Project, type Wire } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { pruneRoutes } from '../../../export/graph/routes.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Clipping } from '../editor/clipping.ts';
import { graphOf, layoutOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { itemId } from '../editor/item-ids.ts';
import { selectOnly } from '../editor/selection.ts';
import { addToast } from '../editor/ui.ts';
import { addCopy } from '../graph/add-copy.ts';
import { placeTogether } from '../graph/free-places.ts';
import { importShadertoy } from '../shaders/import-shadertoy.ts';
import { addDependencies, dependenciesOf, isCopiedDependencies, mapTypes } from './copied-dependencies.ts';
import { hasAssets, isCopiedFiles, readCopiedFiles, writeCopiedFiles } from './copied-files.ts';

export interface PasteOptions {
  /** Wires from existing nodes to copied nodes. */
  readonly entering?: readonly Wire[];
  /** Paths of the asset files in the open project, by asset id. */
  readonly paths?: ReadonlyMap<string, string>;
}

const OFFSET_PX = 32;

/** Copies the selected nodes; null if none is selected. */
export function clipSelection(editor: Editor): Clipping | null {
  const state = editor.document.getState();
  const graph = graphOf(state);
  const layout = layoutOf(state);
  const ids = [...editor.selection.getState().nodes].sort();
  if (ids.length === 0) return null;
  const nodes: Record<string, GraphNode & NodeLayout> = {};
  for (const id of ids) {
    const node = getOwn(graph.nodes, id);
    const place = getOwn(layout.nodes, id);
    if (node) nodes[id] = { ...node, x: 0, y: 0, ...place };
  }
  const brought = dependenciesOf(state.project, Object.values(nodes));
  const wires = graph.wires.filter(({ from, to }) => nodes[from.node] && nodes[to.node]);
  const { reroutes, routes } = pruneRoutes({ wires }, layout);
  const ways = Object.keys(routes).length > 0 ? { ways: { reroutes, routes } } : {};
  return { format: 'scrim-nodes', version: 1, nodes, wires, ...ways, ...(brought === null ? {} : { brought }) };
}

/**
 * Parses clipboard text; null if it is not a clipping. Only the structure is checked here; the commands that add the content check
 * the rest.
 */
export function parseClipping(text: string): Clipping | null {
  try {
    const clipping = JSON.parse(text) as Partial<Clipping> | null;
    const whole = clipping?.format === 'scrim-nodes' && clipping.version === 1 && Array.isArray(clipping.wires);
    const hasNodes = whole && typeof clipping.nodes === 'object' && clipping.nodes !== null;
    return hasNodes && areWays(clipping.ways) && isCopiedDependencies(clipping.brought) && isCopiedFiles(clipping.files)
      ? (clipping as Clipping)
      : null;
  } catch {
    return null;
  }
}

function areWays(value: unknown): boolean {
  if (value === undefined) return true;
  const { reroutes, routes } = (value ?? {}) as Partial<Record<'reroutes' | 'routes', unknown>>;
  if (!isTable(reroutes) || !isTable(routes)) return false;
  const areRoutes = Object.values(routes).every((route) => Array.isArray(route) && route.every((id) => typeof id === 'string'));
  return areRoutes && Object.values(reroutes).every(isPlace);
}

function isTable(value: unknown): value is object {
  return typeof value === 'object' && value !== null;
}

function isPlace(value: unknown): boolean {
  const { x, y } = (value ?? {}) as Partial<Place>;
  return Number.isFinite(x) && Number.isFinite(y);
}

/**
 * Adds copies of the nodes under new ids, connects them as the originals are connected to each other, and selects them. They are moved down
 * together until they cover no other node. One undo step. A project has only one Output; a second one is left out with a message.
 */
export function pasteClipping(
  editor: Editor,
  clipping: Clipping,
  label: string,
  offset: Place,
  { entering = [], paths }: PasteOptions = {},
): boolean {
  const { project, graph } = editor.document.getState();
  const { nodes: copied, wires, ways = { reroutes: {}, routes: {} }, brought } = withoutSecondOutput(editor, clipping);
  if (Object.keys(copied).length === 0) return false;
  const { routes } = layoutOf(editor.document.getState());
  const reroutes = new Map<string, string>();
  const routeWire = (before: Project, wire: Wire, route: readonly string[] = []) =>
    route.length === 0 ? unchanged(before) : setRoutes(before, { graph, routes: { [printWire(wire)]: route } });
  const added = brought === undefined ? null : addDependencies(editor, brought, paths);
  const nodes = added === null ? copied : mapTypes(copied, added.types);
  const ids = new Map<string, string>();
  let library = editor.document.getState().library;
  const made = sequence(
    project,
    (before) => {
      const change = added === null ? unchanged(before) : added.change(before);
      library = editor.libraries.of(change.project);
      return change;
    },
    ...Object.entries(nodes).map(([old, node]) => (before: Project): Change => {
      const id = makeNodeId(before, node.type, editor.random);
      ids.set(old, id);
      return addCopy(before, { library, graph, id, node: { ...node, x: node.x + offset.x, y: node.y + offset.y } });
    }),
    ...entering.map(({ from, to }) => (before: Project): Change => {
      const node = ids.get(to.node);
      if (node === undefined) return unchanged(before);
      const copy = { from, to: { node, port: to.port } };
      return sequence(
        before,
        (p) => connect(p, { library, graph, ...copy }),
        // The copy of the wire uses the same reroutes.
        (p) => routeWire(p, copy, getOwn(routes, printWire({ from, to }))),
      );
    }),
    ...Object.entries(ways.reroutes).map(([old, { x, y }]) => (before: Project): Change => {
      const id = makeLayoutId(before, graph, 'reroute', editor.random);
      reroutes.set(old, id);
      return putReroute(before, { graph, id, reroute: { x: x + offset.x, y: y + offset.y } });
    }),
    ...wires.map(({ from, to }) => (before: Project): Change => {
      const fromId = ids.get(from.node);
      const toId = ids.get(to.node);
      if (fromId === undefined || toId === undefined) return unchanged(before);
      const copy = { from: { node: fromId, port: from.port }, to: { node: toId, port: to.port } };
      return sequence(
        before,
        (p) => connect(p, { library, graph, ...copy }),
        (p) =>
          routeWire(
            p,
            copy,
            getOwn(ways.routes, printWire({ from, to }))?.flatMap((id) => reroutes.get(id) ?? []),
          ),
      );
    }),
    (before) => placeTogether(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails })(before),
  );
  if (!apply(editor, label, made)) return false;
  const there = layoutOf(editor.document.getState()).reroutes;
  const kept = [...reroutes.values()].filter((id) => getOwn(there, id) !== undefined);
  selectOnly(
    editor.selection,
    ids.values(),
    [],
    kept.map((id) => itemId('reroute', id)),
  );
  return true;
}

/** Removes Output nodes if the open graph cannot contain another one, and shows a message. */
function withoutSecondOutput(editor: Editor, clipping: Clipping): Clipping {
  const state = editor.document.getState();
  const screens = screensOf(clipping, state.library);
  const isTaken = state.graph !== MAIN_GRAPH || screensOf(graphOf(state), state.library).length > 0;
  if (screens.length === 0 || !isTaken) return clipping;
  addToast(editor.ui, { tone: 'info', text: 'The Output was not pasted, because a project has only one.' });
  return { ...clipping, nodes: Object.fromEntries(Object.entries(clipping.nodes).filter(([id]) => !screens.includes(id))) };
}

/**
 * Copies the selected nodes within the graph. Returns false if none is selected.
 *
 * @param wired Whether the copies also get the incoming wires of the originals from other nodes.
 */
export function duplicateSelection(editor: Editor, { wired = false } = {}): boolean {
  const clipping = clipSelection(editor);
  if (clipping === null) return false;
  const isCopied = (id: string) => getOwn(clipping.nodes, id) !== undefined;
  const { wires } = graphOf(editor.document.getState());
  const entering = wired ? wires.filter(({ from, to }) => isCopied(to.node) && !isCopied(from.node)) : [];
  const [only] = Object.keys(clipping.nodes).length === 1 ? Object.keys(clipping.nodes) : [];
  const what = only === undefined ? `${Object.keys(clipping.nodes).length} nodes` : titleOf(editor.document.getState(), only);
  return pasteClipping(editor, clipping, `Duplicate ${what}`, { x: OFFSET_PX, y: OFFSET_PX }, { entering });
}

/** Adds the contents of the asset files, so that other projects can use the clipping. */
async function withFiles(editor: Editor, clipping: Clipping): Promise<Clipping> {
  return hasAssets(clipping.brought) ? { ...clipping, files: await readCopiedFiles(editor, clipping.brought) } : clipping;
}

/**
 * Handles the copy event of the page, which needs no permission but must answer synchronously. Returns the clipping as text, and
 * writes it to the clipboard again with its asset files once they have been read.
 */
export function clipboardTextOfSelection(editor: Editor): string | null {
  const clipping = clipSelection(editor);
  if (clipping === null) return null;
  editor.copied.newest = clipping;
  if (hasAssets(clipping.brought)) void write(editor, clipping);
  return JSON.stringify(clipping);
}

async function pasteWithFiles(editor: Editor, clipping: Clipping): Promise<void> {
  const place = { x: OFFSET_PX, y: OFFSET_PX };
  const { brought, files } = clipping;
  if (files === undefined) {
    pasteClipping(editor, clipping, 'Paste', place);
    return;
  }
  await editor.fileWork(async () => {
    const paths = await writeCopiedFiles(editor, brought, files);
    pasteClipping(editor, clipping, 'Paste', place, { paths });
  });
}

export async function copySelection(editor: Editor): Promise<boolean> {
  const clipping = clipSelection(editor);
  if (clipping === null) return false;
  editor.copied.newest = clipping;
  return write(editor, clipping);
}

async function write(editor: Editor, clipping: Clipping): Promise<boolean> {
  const whole = await withFiles(editor, clipping);
  if (editor.copied.newest !== clipping) return true;
  return editor.clipboard.write(JSON.stringify(whole)).then(
    () => true,
    () => {
      addToast(editor.ui, { tone: 'error', text: 'The browser denied access to the clipboard.' });
      return false;
    },
  );
}

/** Deletes the nodes after they have been copied, even if another graph is open by then. */
export function cutSelection(editor: Editor): Promise<void> {
  const { graph } = editor.document.getState();
  const nodes = [...editor.selection.getState().nodes];
  return editor.fileWork(async () => {
    if (!(await copySelection(editor))) return;
    const { project, library } = editor.document.getState();
    const there = nodes.filter((id) => getOwn(getOwn(project.graphs, graph)?.nodes ?? {}, id) !== undefined);
    if (there.length > 0) apply(editor, 'Cut', removeNodes(project, { library, graph, nodes: there }));
  });
}

export async function pasteFromClipboard(editor: Editor): Promise<void> {
  const text = await editor.clipboard.read().catch(() => '');
  const pasted = pasteText(editor, text);
  if (pasted) await pasted;
  else addToast(editor.ui, { tone: 'info', text: 'The clipboard contains no nodes.' });
}

/** Pastes nodes, or imports Shadertoy source as a shader and its node. Null if the text is neither. */
export function pasteText(editor: Editor, text: string): Promise<void> | null {
  const clipping = parseClipping(text);
  if (clipping !== null) return pasteWithFiles(editor, clipping);
  if (!isShadertoy(text)) return null;
  importShadertoy(editor, { source: text, name: 'Shadertoy' });
  return Promise.resolve();
}
