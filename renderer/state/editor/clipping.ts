import type { ProjectTexts } from '../../../export/graph/load.ts';
import type { GraphLayout, GraphNode, NodeLayout, Wire } from '../../../export/graph/project.ts';

/** The subgraphs, shaders and assets that copied nodes are made of, as the files of a project that has nothing else. */
export type CopiedDependencies = ProjectTexts;

/** What copied nodes' assets have in their files, by asset id, as base64: clipboards carry text alone between programs. */
export type CopiedFiles = Readonly<Record<string, string>>;

/** Nodes and the wires among them, with the subgraphs and shaders that they are made of, as text that another window can take. */
export interface Clipping {
  readonly format: 'scrim-nodes';
  readonly version: 1;
  readonly nodes: Readonly<Record<string, GraphNode & NodeLayout>>;
  readonly wires: readonly Wire[];
  /** Of the wires; absent where all run straight. */
  readonly ways?: Pick<GraphLayout, 'reroutes' | 'routes'>;
  /** Absent where they use none. */
  readonly brought?: CopiedDependencies;
  /** Of the assets that they use. */
  readonly files?: CopiedFiles;
}
