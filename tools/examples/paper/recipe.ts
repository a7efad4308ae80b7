import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import type { Change } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { bindParam } from '../../../export/graph/commands/param-commands.ts';
import { setPage } from '../../../export/graph/commands/project-info.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { newProject } from '../../../export/graph/new-project.ts';
import { type Asset, type Binding, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { parseWire } from '../../../export/graph/wires.ts';
import type { NodeLibrary, ParamValue } from '../../../nodes/kit/definition.ts';
import { formatDiagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';

/** A node: type, column and row on the canvas, and params. */
export type RecipeNode = readonly [type: string, column: number, row: number, params?: Readonly<Record<string, ParamValue>>];

/** A small project in short form, from which `makeProject` builds an example. */
export interface Recipe {
  /** Folder in `examples/`. */
  readonly folder: string;
  /** Figure of "A Mixed-Reality Rendering Framework for Photorealistic and Non-Photorealistic Rendering" that it shows, such as `12e`. */
  readonly figure: string;
  readonly title: string;
  readonly description: string;
  /** Nodes, by the word that their ids begin with. */
  readonly nodes: Readonly<Record<string, RecipeNode>>;
  /** Wires, written as `word.port -> word.port`. */
  readonly wires: readonly string[];
  /** Bindings other than values, by `word.param`. */
  readonly bindings?: Readonly<Record<string, Binding>>;
  readonly assets?: Readonly<Record<string, Asset>>;
}

/** Distance between columns and between rows of nodes on the canvas, in canvas units. */
const PITCH_PX = { x: 250, y: 190 } as const;

/**
 * Builds the project with the commands of the editor.
 *
 * @throws If a command rejects a change.
 */
export function makeProject(library: NodeLibrary, recipe: Recipe): Project {
  const { figure, title, description, nodes, wires, bindings = {}, assets = {} } = recipe;
  const graph = MAIN_GRAPH;
  const idOf = (word: string): string => `${word}-f${figure}`;
  let project = newProject(title);
  const apply = ({ project: next, diagnostics }: Change): void => {
    if (hasErrors(diagnostics)) throw new Error(`${recipe.folder}: ${diagnostics.map(formatDiagnostic).join(' ')}`);
    project = next;
  };
  apply(setPage(project, { page: { description } }));
  for (const [id, asset] of Object.entries(assets)) apply(putAsset(project, { id, asset }));
  for (const [word, [type, column, row, params = {}]] of Object.entries(nodes)) {
    apply(addNode(project, { library, graph, id: idOf(word), type, x: column * PITCH_PX.x, y: row * PITCH_PX.y, params }));
  }
  for (const text of wires) {
    const wire = parseWire(text.replace(/(\w+)\./g, (_, word: string) => `${idOf(word)}.`));
    if (!wire) throw new Error(`${recipe.folder}: ${text} is no wire.`);
    apply(connect(project, { library, graph, ...wire }));
  }
  for (const [at, binding] of Object.entries(bindings)) {
    const [word = '', param = ''] = at.split('.');
    apply(bindParam(project, { library, graph, node: idOf(word), param, binding }));
  }
  return project;
}
