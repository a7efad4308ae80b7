import { sequence } from '../../../export/graph/commands/change.ts';
import { changeType } from '../../../export/graph/commands/change-type.ts';
import { createSubgraph as createSubgraphFrom } from '../../../export/graph/commands/create-subgraph.ts';
import { exposePort, hidePort, renameExposed, renameGraph } from '../../../export/graph/commands/subgraph-commands.ts';
import { duplicateSubgraph, ungroupSubgraph } from '../../../export/graph/commands/ungroup-subgraph.ts';
import { makeNodeId, subgraphName, subgraphType } from '../../../export/graph/document-names.ts';
import { type ExposedPorts, MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { sameAddress } from '../../../export/graph/wires.ts';
import { apply } from '../document/apply.ts';
import { type DocumentState, graphOf, layoutOf, nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { selectNothing, selectOnly, soleNode } from '../editor/selection.ts';
import { addToast, revealNodes } from '../editor/ui.ts';

/** Name of the subgraph if one instance is selected; else null. */
export function selectedSubgraph(editor: Editor): string | null {
  const node = soleNode(editor.selection.getState());
  return node === null ? null : subgraphName(nodeOf(editor.document.getState(), node)?.type ?? '');
}

/** Opens a subgraph of the open graph. */
export function openSubgraph(editor: Editor, name: string): void {
  const { graph, trail, project } = editor.document.getState();
  if (getOwn(project.graphs, name) === undefined) return;
  show(editor, name, [...trail, graph]);
}

/** Opens an ancestor of the open graph; `depth` 0 is the main graph. */
export function openOnTrail(editor: Editor, depth: number): void {
  const { trail } = editor.document.getState();
  const graph = trail[depth];
  if (graph !== undefined) show(editor, graph, trail.slice(0, depth));
}

export function leaveSubgraph(editor: Editor): void {
  const { trail, graph } = editor.document.getState();
  openOnTrail(editor, trail.length - 1);
  // Selects the instance that was left.
  const instance = Object.entries(graphOf(editor.document.getState()).nodes).find(([, { type }]) => type === subgraphType(graph));
  if (instance) selectOnly(editor.selection, [instance[0]]);
}

function show(editor: Editor, graph: string, trail: readonly string[]): void {
  selectNothing(editor.selection);
  editor.document.setState({ graph, trail });
  // The nodes must be mounted first.
  editor.clock.nextFrame(() => revealNodes(editor.ui, [], 'fit'));
}

/** Moves the selected nodes into a new subgraph and selects its instance. */
export function createSubgraph(editor: Editor): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const nodes = [...editor.selection.getState().nodes];
  const places = nodes.map((id) => getOwn(layoutOf(state).nodes, id) ?? { x: 0, y: 0 });
  const middle = (side: 'x' | 'y') => places.reduce((sum, place) => sum + place[side], 0) / Math.max(places.length, 1);
  const name = freeName(project, 'subgraph');
  const id = makeNodeId(project, subgraphType(name), editor.random);
  const change = createSubgraphFrom(project, { library, graph, nodes, name, id, x: middle('x'), y: middle('y') });
  if (!apply(editor, 'Create subgraph', change)) return false;
  selectOnly(editor.selection, [id]);
  return true;
}

/** Replaces the selected instance by the contents of its subgraph, and selects them. */
export function ungroupSelected(editor: Editor): boolean {
  const { project, library, graph } = editor.document.getState();
  const node = soleNode(editor.selection.getState());
  if (node === null) return false;
  const before = new Set(Object.keys(graphOf(editor.document.getState()).nodes));
  if (!apply(editor, 'Ungroup subgraph', ungroupSubgraph(project, { library, graph, node, random: editor.random }))) return false;
  selectOnly(
    editor.selection,
    Object.keys(graphOf(editor.document.getState()).nodes).filter((id) => !before.has(id)),
  );
  return true;
}

/** Gives the selected instance its own copy of the subgraph. */
export function makeUnique(editor: Editor): boolean {
  const { project, graph } = editor.document.getState();
  const node = soleNode(editor.selection.getState());
  const from = selectedSubgraph(editor);
  if (node === null || from === null) return false;
  const to = freeName(project, from.replace(/-\d+$/, ''));
  const change = sequence(
    project,
    (before) => duplicateSubgraph(before, { from, to, random: editor.random }),
    (before) => changeType(before, { library: editor.libraries.of(before), graph, node, type: subgraphType(to) }),
  );
  return apply(editor, 'Make subgraph unique', change);
}

/** Makes a name from a title: “Söft look” becomes `soft-look`. Empty if the title contains no letter. */
export function nameOfTitle(title: string): string {
  const words =
    title
      .normalize('NFKD')
      .replaceAll(/\p{M}/gu, '')
      .toLowerCase()
      .match(/[a-z0-9]+/g) ?? [];
  return words.join('-').replace(/^[0-9-]+/, '');
}

export function renameSubgraph(editor: Editor, from: string, title: string): boolean {
  const to = nameOfTitle(title);
  if (to === from) return true;
  if (to === '') {
    addToast(editor.ui, { tone: 'error', text: 'The name must begin with a letter.' });
    return false;
  }
  const { project, graph, trail } = editor.document.getState();
  if (!apply(editor, 'Rename subgraph', renameGraph(project, { from, to }))) return false;
  const renamed = (name: string) => (name === from ? to : name);
  editor.document.setState({ graph: renamed(graph), trail: trail.map(renamed) });
  return true;
}

export type PortSide = keyof ExposedPorts;

/** The name under which a port of the open subgraph is exposed; null if it is not. */
export function exposedName(exposed: ExposedPorts, side: PortSide, address: PortAddress): string | null {
  return exposed[side].find((port) => sameAddress(port, address))?.name ?? null;
}

/** Whether a port or param of the open subgraph can be exposed: it exists, is not exposed, and has no wire where it takes only one. */
export function canExpose(editor: Editor, side: PortSide, address: PortAddress): boolean {
  const { project, library, graph } = editor.document.getState();
  if (graph === MAIN_GRAPH) return false;
  const name = freePortName(editor, address);
  return exposePort(project, { library, graph, side, name, ...address }).patches.length > 0;
}

/** Exposes a port or param of the open subgraph, or stops exposing it. */
export function setPortExposed(editor: Editor, side: PortSide, { node, port }: PortAddress, shown: boolean): boolean {
  const state = editor.document.getState();
  const { project, library, graph } = state;
  const { exposed } = graphOf(state);
  if (graph === MAIN_GRAPH) return false;
  const known = exposedName(exposed, side, { node, port });
  if (!shown) return known === null || apply(editor, 'Stop exposing port', hidePort(project, { library, graph, side, name: known }));
  const name = freePortName(editor, { node, port });
  return apply(editor, 'Expose port', exposePort(project, { library, graph, side, name, node, port }));
}

/** Makes the name of a port from a title: “Söft look” becomes `softLook`. Empty if the title contains no letter. */
function portNameOfTitle(title: string): string {
  return nameOfTitle(title.replaceAll(/([a-z])([A-Z])/g, '$1 $2')).replaceAll(/-(.)/g, (_, letter: string) => letter.toUpperCase());
}

/** Why an exposed port of the open subgraph cannot be renamed to this title; null if it can. */
export function exposedTitleProblem(state: DocumentState, name: string, title: string): string | null {
  const wanted = portNameOfTitle(title);
  if (wanted === '') return 'The name must begin with a letter.';
  const { inputs, outputs } = graphOf(state).exposed;
  const isTaken = wanted !== name && [...inputs, ...outputs].some((port) => port.name === wanted);
  return isTaken ? 'The subgraph already has a port of this name.' : null;
}

/** Renames an exposed port of the open subgraph, at its instances, too. */
export function renameExposedPort(editor: Editor, side: PortSide, name: string, title: string): boolean {
  const { project, graph } = editor.document.getState();
  const to = portNameOfTitle(title);
  return to === name || apply(editor, 'Rename port', renameExposed(project, { graph, side, from: name, to }));
}

/** A name for an exposed port that the open subgraph does not have. */
function freePortName(editor: Editor, { port }: PortAddress): string {
  const { exposed } = graphOf(editor.document.getState());
  const taken = new Set([...exposed.inputs, ...exposed.outputs].map(({ name }) => name));
  let name = port;
  for (let number = 2; taken.has(name); number++) name = `${port}${number}`;
  return name;
}

function freeName({ graphs }: Project, stem: string): string {
  let name = stem;
  for (let number = 2; getOwn(graphs, name) !== undefined; number++) name = `${stem}-${number}`;
  return name;
}
