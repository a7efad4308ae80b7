import { createStore, type StoreApi } from 'zustand/vanilla';
import type { HostOutput, OpenProject } from '../../../app/contract/contract.ts';
import { emptyHistory, type History } from '../../../export/graph/history.ts';
import type { ProjectLibrary } from '../../../export/graph/library/project-library.ts';
import { EMPTY_GRAPH, EMPTY_LAYOUT, newProject } from '../../../export/graph/new-project.ts';
import { type Graph, type GraphLayout, type GraphNode, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

/** The project that is open, as its folder had it. */
export type OpenInfo = Pick<OpenProject, 'handle' | 'displayPath' | 'revision' | 'assetBaseUrl' | 'assetFiles'>;

export interface DocumentState {
  /** Null before a project is open. */
  readonly open: OpenInfo | null;
  readonly project: Project;
  /** Name of the graph on the canvas. */
  readonly graph: string;
  /** The graphs that it was reached through, from the main one on; empty for the main one. */
  readonly trail: readonly string[];
  /** The node types and shaders there are for this project, its own included. */
  readonly library: ProjectLibrary;
  readonly history: History;
  /** State of the history that the folder has. */
  readonly savedState: number;
  /** Raised by every change, so that answers from workers can be told to be late. */
  readonly revision: number;
  /** From loading: faults in the files that did not prevent opening them. */
  readonly loadDiagnostics: readonly Diagnostic[];
  /** What the shell can do, from `app.info`. */
  readonly canPickFolders: boolean;
  readonly examples: HostOutput<'app.info'>['examples'];
  readonly templates: HostOutput<'app.info'>['templates'];
}

/** What is needed to look things up in the open graph. */
export type OpenGraph = Pick<DocumentState, 'project' | 'graph' | 'library'>;

export type DocumentStore = StoreApi<DocumentState>;

export function createDocument(library: ProjectLibrary): DocumentStore {
  const project = newProject('Untitled');
  return createStore<DocumentState>(() => ({
    open: null,
    project,
    graph: MAIN_GRAPH,
    trail: [],
    library,
    history: emptyHistory(),
    savedState: 0,
    revision: 0,
    loadDiagnostics: [],
    canPickFolders: false,
    examples: [],
    templates: [],
  }));
}

export function isDirty({ history, savedState }: DocumentState): boolean {
  return history.state !== savedState;
}

export function graphOf({ project, graph }: Pick<OpenGraph, 'project' | 'graph'>): Graph {
  return getOwn(project.graphs, graph) ?? EMPTY_GRAPH;
}

export function layoutOf({ project, graph }: Pick<OpenGraph, 'project' | 'graph'>): GraphLayout {
  return getOwn(project.layout, graph) ?? EMPTY_LAYOUT;
}

export function nodeOf(state: Pick<OpenGraph, 'project' | 'graph'>, id: string): GraphNode | undefined {
  return getOwn(graphOf(state).nodes, id);
}

/** What people call the node: its type's title; its id where the type is unknown. */
export function titleOf(state: OpenGraph, id: string): string {
  const type = nodeOf(state, id)?.type;
  return (type === undefined ? undefined : state.library.definition(type)?.title) ?? id;
}
