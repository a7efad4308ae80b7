import type { ProjectTexts } from '../../../export/graph/load.ts';
import type { GraphLayout, GraphNode, NodeLayout, Wire } from '../../../export/graph/project.ts';

/** The subgraphs, shaders and assets that copied nodes need, as the files of a project. */
export type CopiedDependencies = ProjectTexts;

/** File contents of the copied assets as base64, by asset id. Clipboards carry only text between programs. */
export type CopiedFiles = Readonly<Record<string, string>>;

/** Copied nodes, the wires among them and their dependencies, as JSON text of the clipboard. */
export interface Clipping {
  readonly format: 'scrim-nodes';
  readonly version: 1;
  readonly nodes: Readonly<Record<string, GraphNode & NodeLayout>>;
  readonly wires: readonly Wire[];
  /** Reroutes of the wires; absent if there are none. */
  readonly ways?: Pick<GraphLayout, 'reroutes' | 'routes'>;
  /** Dependencies of the nodes; absent if there are none. */
  readonly brought?: CopiedDependencies;
  /** Files of the assets. */
  readonly files?: CopiedFiles;
}
