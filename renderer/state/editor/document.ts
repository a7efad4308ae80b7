import { createStore, type StoreApi } from 'zustand/vanilla';
import type { HostOutput, OpenProject } from '../../../app/contract/contract.ts';
import { emptyHistory, type History } from '../../../export/graph/history.ts';
import type { ProjectLibrary } from '../../../export/graph/library/project-library.ts';
import { EMPTY_GRAPH, EMPTY_LAYOUT, newProject } from '../../../export/graph/new-project.ts';
import { type Graph, type GraphLayout, type GraphNode, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { nodeTitle } from './node-title.ts';

/** The open project, as the host describes it. */
export interface OpenInfo extends Pick<OpenProject, 'handle' | 'displayPath' | 'revision' | 'assetBaseUrl' | 'assetFiles'> {
  /** Whether the project was just created. What is kept of an earlier project in the same folder does not apply to it. */
  readonly isNew?: boolean;
}

export interface DocumentState {
  /** The open project; null if there is none. */
  readonly open: OpenInfo | null;
  readonly project: Project;
  /** Name of the open graph, which the canvas shows. */
  readonly graph: string;
  /** Names of the graphs from the main graph to the parent of the open one; empty in the main graph. */
  readonly trail: readonly string[];
  /** Node types and shaders of Scrim and of the project. */
  readonly library: ProjectLibrary;
  readonly history: History;
  /** State of the history at the last save. */
  readonly savedState: number;
  /** Incremented by each change, so that late answers of workers can be recognized. */
  readonly revision: number;
  /** Problems found while loading. */
  readonly loadDiagnostics: readonly Diagnostic[];
  /** Whether the host has a native folder dialog, from `app.info`. */
  readonly canPickFolders: boolean;
  /** Whether the host shows files in the file manager, from `app.info`. */
  readonly canReveal: boolean;
  /** Folder for the projects of the user; empty until the host has answered `app.info`. */
  readonly projectsDir: string;
  readonly examples: HostOutput<'app.info'>['examples'];
  readonly templates: HostOutput<'app.info'>['templates'];
}

/** The part of the document that lookups in the open graph need. */
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
    canReveal: false,
    projectsDir: '',
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

/** The name of a node of the open graph, as `nodeTitle` gives it; its id if there is no such node. */
export function titleOf(state: OpenGraph, id: string): string {
  const node = nodeOf(state, id);
  return node === undefined ? id : nodeTitle(node, state.library, state.project.assets);
}
