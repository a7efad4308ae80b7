import type { Change } from '../../export/graph/commands/change.ts';
import { addNode } from '../../export/graph/commands/node-commands.ts';
import { addGraph, exposePort } from '../../export/graph/commands/subgraph-commands.ts';
import { connect } from '../../export/graph/commands/wire-commands.ts';
import { newProject } from '../../export/graph/new-project.ts';
import { type Asset, type Frame, MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import { parseWire } from '../../export/graph/wires.ts';
import type { NodeLibrary, ParamValue } from '../../nodes/kit/definition.ts';
import { formatDiagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';

/** Builds a project, graph by graph, with the editor's commands. Throws if a command rejects a change. */
export interface GalleryBuilder {
  /** Selects the graph for the following calls; creates it if it does not exist. */
  into(graph: string): void;
  add(id: string, type: string, at: { readonly x: number; readonly y: number }, params?: Readonly<Record<string, ParamValue>>): void;
  /** Adds a wire, written as `node.port -> node.port`. */
  wire(text: string): void;
  /** Exposes `node.port` of a subgraph. */
  show(side: 'inputs' | 'outputs', name: string, address: string): void;
  frame(title: string, box: Omit<Frame, 'title'>): void;
  asset(id: string, asset: Asset): void;
  finish(): Project;
}

export function createGalleryBuilder(library: NodeLibrary, title: string): GalleryBuilder {
  let project = newProject(title);
  let graph: string = MAIN_GRAPH;
  const frames: Record<string, Record<string, Frame>> = {};
  const apply = ({ project: next, diagnostics }: Change): void => {
    if (hasErrors(diagnostics)) throw new Error(diagnostics.map(formatDiagnostic).join(' '));
    project = next;
  };
  return {
    into: (name) => {
      if (!Object.hasOwn(project.graphs, name)) apply(addGraph(project, { name }));
      graph = name;
    },
    add: (id, type, { x, y }, params = {}) => apply(addNode(project, { library, graph, id, type, x, y, params })),
    wire: (text) => {
      const wire = parseWire(text);
      if (!wire) throw new Error(`${text} is no wire.`);
      apply(connect(project, { library, graph, ...wire }));
    },
    show: (side, name, address) => {
      const [node = '', port = ''] = address.split('.');
      apply(exposePort(project, { library, graph, side, name, node, port }));
    },
    frame: (frameTitle, box) => {
      const here = frames[graph] ?? {};
      frames[graph] = { ...here, [`frame-${Object.keys(here).length + 1}`]: { ...box, title: frameTitle } };
    },
    asset: (id, asset) => {
      project = { ...project, assets: { ...project.assets, [id]: asset } };
    },
    finish: () => {
      const framed = Object.entries(project.layout).map(([name, layout]) => [name, { ...layout, frames: frames[name] ?? {} }] as const);
      return { ...project, layout: Object.fromEntries(framed) };
    },
  };
}
