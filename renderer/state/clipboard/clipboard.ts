import { isShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { setCollapsed } from '../../../export/graph/commands/layout-commands.ts';
import { addNode, removeNodes, setMuted } from '../../../export/graph/commands/node-commands.ts';
import { bindParam } from '../../../export/graph/commands/param-commands.ts';
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
import { importShadertoy } from '../shaders/import-shadertoy.ts';
import { bring, dependenciesOf, isCopiedDependencies, mapTypes } from './copied-dependencies.ts';
import { hasAssets, isCopiedFiles, readCopiedFiles, writeCopiedFiles } from './copied-files.ts';

export interface PasteOptions {
  /** Wires that come from nodes that are there, and go to copies. */
  readonly entering?: readonly Wire[];
  /** Asset id → where its file is in the open project. */
  readonly paths?: ReadonlyMap<string, string>;
}

const OFFSET_PX = 32;

/** The selected nodes; null where none is. */
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

/** Null where the text is no clipping. What is in it is judged by the commands that add it. */
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
 * Adds copies under new ids, wired as the originals are among themselves, and selects them. One step. A project shows one screen:
 * another stays out, and that is said.
 */
export function pasteClipping(
  editor: Editor,
  clipping: Clipping,
  label: string,
  offset: Place,
  { entering = [], paths }: PasteOptions = {},
): boolean {
  const { project, graph } = editor.document.getState();
  const { nodes: copied, wires, ways = { reroutes: {}, routes: {} }, brought } = withoutScreens(editor, clipping);
  if (Object.keys(copied).length === 0) return false;
  const { routes } = layoutOf(editor.document.getState());
  const reroutes = new Map<string, string>();
  const lead = (before: Project, wire: Wire, route: readonly string[] = []) =>
    route.length === 0 ? unchanged(before) : setRoutes(before, { graph, routes: { [printWire(wire)]: route } });
  const welcome = brought === undefined ? null : bring(editor, brought, paths);
  const nodes = welcome === null ? copied : mapTypes(copied, welcome.types);
  const ids = new Map<string, string>();
  let library = editor.document.getState().library;
  const made = sequence(
    project,
    (before) => {
      const change = welcome === null ? unchanged(before) : welcome.change(before);
      library = editor.libraries.of(change.project);
      return change;
    },
    ...Object.entries(nodes).map(([old, node]) => (before: Project): Change => {
      const id = makeNodeId(before, node.type, editor.random);
      ids.set(old, id);
      return sequence(
        before,
        (p) => addNode(p, { library, graph, id, type: node.type, x: node.x + offset.x, y: node.y + offset.y }),
        ...Object.entries(node.params).map(
          ([param, binding]) =>
            (p: Project) =>
              bindParam(p, { library, graph, node: id, param, binding }),
        ),
        (p) => (node.muted ? setMuted(p, { graph, nodes: [id], muted: true }) : unchanged(p)),
        (p) => (node.collapsed ? setCollapsed(p, { graph, nodes: [id], collapsed: true }) : unchanged(p)),
      );
    }),
    ...entering.map(({ from, to }) => (before: Project): Change => {
      const node = ids.get(to.node);
      if (node === undefined) return unchanged(before);
      const copy = { from, to: { node, port: to.port } };
      return sequence(
        before,
        (p) => connect(p, { library, graph, ...copy }),
        // It leaves the old way at its last reroute.
        (p) => lead(p, copy, getOwn(routes, printWire({ from, to }))),
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
          lead(
            p,
            copy,
            getOwn(ways.routes, printWire({ from, to }))?.flatMap((id) => reroutes.get(id) ?? []),
          ),
      );
    }),
  );
  if (!apply(editor, label, made)) return false;
  const there = layoutOf(editor.document.getState()).reroutes;
  const led = [...reroutes.values()].filter((id) => getOwn(there, id) !== undefined);
  selectOnly(
    editor.selection,
    ids.values(),
    [],
    led.map((id) => itemId('reroute', id)),
  );
  return true;
}

/** The clipping without what the open graph cannot take or has already; says so where that leaves something out. */
function withoutScreens(editor: Editor, clipping: Clipping): Clipping {
  const state = editor.document.getState();
  const screens = screensOf(clipping, state.library);
  const isTaken = state.graph !== MAIN_GRAPH || screensOf(graphOf(state), state.library).length > 0;
  if (screens.length === 0 || !isTaken) return clipping;
  addToast(editor.ui, { tone: 'info', text: 'Without the screen: a project has one, which is there already.' });
  return { ...clipping, nodes: Object.fromEntries(Object.entries(clipping.nodes).filter(([id]) => !screens.includes(id))) };
}

/** `wired`: what comes into the originals from other nodes comes into the copies, too. */
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

/** The clipping with what its assets have in their files, so that a project without them can take it. */
async function withFiles(editor: Editor, clipping: Clipping): Promise<Clipping> {
  return hasAssets(clipping.brought) ? { ...clipping, files: await readCopiedFiles(editor, clipping.brought) } : clipping;
}

/**
 * For the page's own copy event, which needs no permission and cannot wait: the clipping as text at once, and the clipboard once more
 * with the assets' files when they have been read.
 */
export function copyInEvent(editor: Editor): string | null {
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
      addToast(editor.ui, { tone: 'error', text: 'The browser did not let Scrim use the clipboard.' });
      return false;
    },
  );
}

/** Takes the nodes away once they are on the clipboard, wherever the person is by then. */
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
  else addToast(editor.ui, { tone: 'info', text: 'There are no nodes on the clipboard.' });
}

/** Nodes become copies of them, a source of shadertoy.com a shader and its node; null where the text is none of these. */
export function pasteText(editor: Editor, text: string): Promise<void> | null {
  const clipping = parseClipping(text);
  if (clipping !== null) return pasteWithFiles(editor, clipping);
  if (!isShadertoy(text)) return null;
  importShadertoy(editor, { source: text, name: 'Shadertoy' });
  return Promise.resolve();
}
