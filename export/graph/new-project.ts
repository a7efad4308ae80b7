import { type Graph, type GraphLayout, MAIN_GRAPH, type PageInfo, type Project } from './project.ts';

export const DEFAULT_PAGE: PageInfo = { description: '', language: 'en' };
export const EMPTY_GRAPH: Graph = { nodes: {}, wires: [], exposed: { inputs: [], outputs: [] } };
export const EMPTY_LAYOUT: GraphLayout = { nodes: {}, frames: {}, notes: {}, reroutes: {}, routes: {} };

/**
 * Creates a project with an empty main graph.
 *
 * @example
 * newProject('Fog').graphs; // { main: EMPTY_GRAPH }
 */
export function newProject(title: string): Project {
  return { title, page: DEFAULT_PAGE, graphs: { [MAIN_GRAPH]: EMPTY_GRAPH }, layout: {}, sources: {}, assets: {} };
}
