import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';
import { isShaderFile, shaderFilesOf } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { projectLibrary, type ReadShader } from '../library/project-library.ts';
import type { Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { carryRename, findRename, type PortRename } from './carry-rename.ts';
import { type Change, change, draftGraph, graphOf, type ProjectDraft, refuse, sequence, unchanged } from './change.ts';
import { pruneConnections } from './prune-connections.ts';

export interface SetSource {
  /** The library without the project's own shaders. */
  readonly base: NodeLibrary;
  /** Reads every shader of the project in each call, so pass a cached one (`createShaderCache`). */
  readonly readShader: ReadShader;
  /** File name in `shaders/`. */
  readonly file: string;
  readonly text: string;
  /** Node types from before a header became invalid. Default: those of the current texts. */
  readonly known?: NodeLibrary;
}

/**
 * Sets the text of a shader of the project and updates the nodes that use it, as one change. Wires and params stay if an input of the same
 * name and type still exists. If exactly one input was renamed, they follow the new name. If the shader becomes another node type (a filter
 * with a second image is a composite), its nodes change their type. An invalid header changes nothing but the text.
 *
 * @returns The change, or a refusal with SCR002 if the file name is invalid.
 *
 * @example
 * setSource(project, { base: library, readShader, file: 'edge.fs', text });
 */
export function setSource(project: Project, { base, readShader, file, text, known }: SetSource): Change {
  if (!isShaderFile(file)) return refuse(project, 'SCR002', `Shader file name “${file}” is invalid.`, { file });
  if (getOwn(project.sources, file) === text) return unchanged(project);
  const sources = { ...project.sources, [file]: text };
  const library = projectLibrary(base, sources, readShader);
  const after = typeOf(library.files, file);
  const write = (before: Project) =>
    change(before, (draft) => {
      draft.sources[file] = text;
    });
  if (after === undefined) return sequence(project, write);
  const old = projectLibrary(base, project.sources, readShader);
  const before = typeOf(old.files, file);
  const stale = before === undefined ? orphanedTypes(file, library) : before === after ? [] : [before];
  const rename = renameOf(before === undefined ? known?.definition(after) : old.definition(after), library.definition(after));
  const retype = (written: Project) =>
    stale.length === 0 ? unchanged(written) : change(written, (draft) => retypeNodes(draft, stale, after));
  const carry = (retyped: Project) => (rename === null ? unchanged(retyped) : carryRename(retyped, after, rename));
  return sequence(project, write, retype, carry, (carried) => pruneConnections(carried, library, [after]));
}

function renameOf(before: NodeDefinition | undefined, after: NodeDefinition | undefined): PortRename | null {
  return before && after ? findRename(before, after) : null;
}

export interface RemoveSource extends Omit<SetSource, 'text' | 'known'> {}

/**
 * Removes a shader from the project.
 *
 * @returns The change, or a refusal with SCR010 if a node uses it and the library has no node type of the same name.
 *
 * @example
 * removeSource(project, { base: library, readShader, file: 'edge.fs' });
 */
export function removeSource(project: Project, { base, readShader, file }: RemoveSource): Change {
  const { [file]: _, ...sources } = project.sources;
  const type = typeOf(projectLibrary(base, project.sources, readShader).files, file);
  const library = projectLibrary(base, sources, readShader);
  const users = Object.values(project.graphs).flatMap(({ nodes }) => Object.keys(nodes).filter((id) => nodes[id]?.type === type));
  const [user] = users;
  if (type !== undefined && user !== undefined && library.definition(type) === undefined) {
    return refuse(project, 'SCR010', `shaders/${file} is used by ${users.join(', ')}.`, { nodeId: user, file: `shaders/${file}` });
  }
  const remove = (before: Project) =>
    change(before, (draft) => {
      delete draft.sources[file];
    });
  return sequence(project, remove, (removed) => pruneConnections(removed, library, type === undefined ? [] : [type]));
}

export interface ForkShader {
  /** The library with the project's own shaders. */
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly node: string;
  /** Name of the copy without its file ending. Default: the original's name with the next free number. */
  readonly name?: string;
}

/**
 * Copies the shader of a node into the project, where it can be edited, and makes the node use the copy.
 *
 * @returns The change, or a refusal: SCR012 or SCR043 if the node does not exist or is not a shader; SCR002 if the name is invalid or in
 * use.
 * @throws Error if the graph does not exist.
 *
 * @example
 * forkShader(project, { library, graph: 'main', node: 'sepia-k7q2', name: 'my-sepia' });
 */
export function forkShader(project: Project, { library, graph, node: id, name }: ForkShader): Change {
  const node = getOwn(graphOf(project, graph).nodes, id);
  if (!node) return refuse(project, 'SCR012', `Node ${id} does not exist.`, { nodeId: id });
  const definition = createInterfaceLookup(project, library)(node.type) && library.definition(node.type);
  const shader = definition && forkableShader(definition, library);
  if (!definition || !shader) {
    return refuse(
      project,
      'SCR043',
      `${id} (${node.type}) is more than a shader. Only filters, composites, generators and techniques can be copied.`,
      {
        nodeId: id,
      },
    );
  }
  const [kind = '', original = ''] = definition.type.split('/');
  const copy = name ?? freeName(project, library, kind, original);
  const file = `${copy}${shader.name.slice(shader.name.lastIndexOf('.'))}`;
  if (!isShaderFile(file)) return refuse(project, 'SCR002', `Shader file name “${file}” is invalid.`, { nodeId: id });
  if (isTaken(project, library, kind, copy)) return refuse(project, 'SCR002', `A shader named “${copy}” already exists.`, { nodeId: id });
  const vertex = shader.name.endsWith('.fs') ? library.shader(shader.name.replace(/\.fs$/, '.vs')) : undefined;
  return change(project, (draft) => {
    draft.sources[file] = shader.text;
    if (vertex !== undefined) draft.sources[`${copy}.vs`] = vertex;
    const drafted = draftGraph(draft, graph).nodes[id];
    if (!drafted) return;
    drafted.type = `${kind}/${copy}`;
    drafted.version = 1;
  });
}

const SHADER_KINDS = ['filter', 'operator', 'generator', 'technique'];

function forkableShader({ type, lowering }: NodeDefinition, library: NodeLibrary): { name: string; text: string } | undefined {
  if ((lowering.kind !== 'image' && lowering.kind !== 'technique') || !SHADER_KINDS.includes(type.slice(0, type.indexOf('/'))))
    return undefined;
  const text = library.shader(lowering.shader);
  return text === undefined ? undefined : { name: lowering.shader, text };
}

function freeName(project: Project, library: NodeLibrary, kind: string, original: string): string {
  const stem = original.replace(/-\d+$/, '');
  for (let number = 2; ; number++) {
    const name = `${stem}-${number}`;
    if (!isTaken(project, library, kind, name)) return name;
  }
}

function isTaken(project: Project, library: NodeLibrary, kind: string, name: string): boolean {
  const type = `${kind}/${name}`;
  return shaderFilesOf(type).some((file) => getOwn(project.sources, file) !== undefined) || library.definition(type) !== undefined;
}

function typeOf(files: ReadonlyMap<string, string>, file: string): string | undefined {
  for (const [type, from] of files) if (from === file) return type;
  return undefined;
}

/** Unknown node types that the file may have defined while its header was valid. */
function orphanedTypes(file: string, library: NodeLibrary): string[] {
  const stem = file.replace(/\.(fs|glsl)$/, '');
  const types = SHADER_KINDS.map((kind) => `${kind}/${stem}`);
  return types.filter((type) => shaderFilesOf(type).includes(file) && library.definition(type) === undefined);
}

function retypeNodes(draft: ProjectDraft, from: readonly string[], to: string): void {
  for (const graph of Object.values(draft.graphs)) {
    for (const node of Object.values(graph.nodes)) if (from.includes(node.type)) node.type = to;
  }
}
