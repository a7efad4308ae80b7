import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { type Change, change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { setSource } from '../../../export/graph/commands/shader-commands.ts';
import { copyOfGraph } from '../../../export/graph/commands/ungroup-subgraph.ts';
import { isChunkFile, shaderFilesOf, subgraphName, subgraphType } from '../../../export/graph/document-names.ts';
import { loadProject } from '../../../export/graph/load.ts';
import { newProject } from '../../../export/graph/new-project.ts';
import { type Graph, type GraphNode, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { saveProject } from '../../../export/graph/save.ts';
import type { CopiedDependencies } from '../editor/clipping.ts';
import type { Editor } from '../editor/editor.ts';

/** Collects what the nodes need in another project: subgraphs, shaders and assets. Null if they need nothing. */
export function dependenciesOf(project: Project, nodes: readonly GraphNode[]): CopiedDependencies | null {
  const graphs: Record<string, Graph> = {};
  const all = [...nodes];
  // The loop also visits the nodes of nested subgraphs, which are appended during it.
  for (const { type } of all) {
    const name = subgraphName(type);
    const graph = name === null ? undefined : getOwn(project.graphs, name);
    if (name === null || !graph || graphs[name]) continue;
    graphs[name] = graph;
    all.push(...Object.values(graph.nodes));
  }
  const stems = new Set(all.flatMap(({ type }) => shaderFilesOf(type).map(stem)));
  const shaders = pick(project.sources, (file) => stems.has(stem(file)));
  const includes = Object.values(shaders).some((text) => text.includes('#include'));
  const sources = pick(project.sources, (file) => Object.hasOwn(shaders, file) || (includes && isChunkFile(file)));
  const values = new Set(
    all.flatMap(({ params }) => Object.values(params).flatMap((binding) => ('value' in binding ? [binding.value] : []))),
  );
  const assets = pick(project.assets, (id) => values.has(id));
  if ([graphs, sources, assets].every((table) => Object.keys(table).length === 0)) return null;
  const empty = newProject('Copied');
  const layout = pick(project.layout, (name) => getOwn(graphs, name) !== undefined);
  return saveProject({ ...empty, graphs: { ...empty.graphs, ...graphs }, layout: { ...empty.layout, ...layout }, sources, assets });
}

/** Whether the value has the structure of `CopiedDependencies`. The texts are checked when they are read. */
export function isCopiedDependencies(value: unknown): value is CopiedDependencies | undefined {
  if (value === undefined) return true;
  const { project, layout, sources } = (value ?? {}) as Partial<Record<keyof CopiedDependencies, unknown>>;
  const isTable = typeof sources === 'object' && sources !== null && Object.values(sources).every((text) => typeof text === 'string');
  return typeof project === 'string' && typeof layout === 'string' && isTable;
}

export interface AddedDependencies {
  /** New node types of copies whose name was already taken, by old type. */
  readonly types: ReadonlyMap<string, string>;
  readonly change: (project: Project) => Change;
}

/**
 * Adds dependencies to the open project. Skips identical content and invalid files.
 *
 * @param paths Paths of the asset files in the open project, by asset id.
 */
export function addDependencies(
  editor: Editor,
  brought: CopiedDependencies,
  paths: ReadonlyMap<string, string> = new Map(),
): AddedDependencies {
  const { project, open } = editor.document.getState();
  const { base, readShader } = editor.libraries;
  const copied = loadProject(brought).output;
  const types = new Map<string, string>();
  if (copied === null || open === null) return { types, change: unchanged };
  const steps: ((project: Project) => Change)[] = [];
  for (const [file, text] of Object.entries(copied.sources)) {
    // A renamed chunk would not be included by any shader, so the chunk of the project stays.
    if (isChunkFile(file) && getOwn(project.sources, file) !== undefined) continue;
    const name = freeKey(project.sources, file, (known) => known === text);
    if (name !== file)
      for (const kind of ['filter', 'operator', 'generator', 'technique']) types.set(`${kind}/${stem(file)}`, `${kind}/${stem(name)}`);
    steps.push((before) => setSource(before, { base, readShader, file: name, text }));
  }
  for (const [id, asset] of Object.entries(copied.assets)) {
    if (getOwn(project.assets, id) === undefined)
      steps.push((before) => putAsset(before, { id, asset: { ...asset, path: paths.get(id) ?? asset.path } }));
  }
  const names = Object.keys(copied.graphs).filter((name) => name !== MAIN_GRAPH);
  const isInProject = (name: string) => JSON.stringify(getOwn(project.graphs, name)) === JSON.stringify(copied.graphs[name]);
  for (const name of names) {
    if (!isInProject(name)) types.set(subgraphType(name), subgraphType(freeKey(project.graphs, name, () => false)));
  }
  for (const name of names.filter((candidate) => !isInProject(candidate))) {
    const graph = copied.graphs[name];
    const to = subgraphName(types.get(subgraphType(name)) ?? '');
    if (!graph || to === null) continue;
    steps.push((before) => {
      const copy = copyOfGraph(before, { ...graph, nodes: mapTypes(graph.nodes, types) }, copied.layout[name], editor.random);
      return change(before, (draft) => {
        Object.assign(draft.graphs, { [to]: copy.graph });
        Object.assign(draft.layout, { [to]: copy.layout });
      });
    });
  }
  return { types, change: (before) => sequence(before, ...steps) };
}

export function mapTypes<N extends { readonly type: string }>(
  nodes: Readonly<Record<string, N>>,
  types: ReadonlyMap<string, string>,
): Readonly<Record<string, N>> {
  return Object.fromEntries(Object.entries(nodes).map(([id, node]) => [id, { ...node, type: types.get(node.type) ?? node.type }]));
}

/** A free key such as `edge-2.fs`. The key itself, if it is free or its value is the same. */
function freeKey<T>(table: Readonly<Record<string, T>>, wanted: string, isSame: (known: T) => boolean): string {
  const ending = /\.\w+$/.exec(wanted)?.[0] ?? '';
  let key = wanted;
  for (let number = 2; ; number++) {
    const known = getOwn(table, key);
    if (known === undefined || isSame(known)) return key;
    key = `${stem(wanted)}-${number}${ending}`;
  }
}

function stem(file: string): string {
  return file.replace(/\.\w+$/, '');
}

function pick<T>(table: Readonly<Record<string, T>>, isWanted: (key: string) => boolean): Record<string, T> {
  return Object.fromEntries(Object.entries(table).filter(([key]) => isWanted(key)));
}
