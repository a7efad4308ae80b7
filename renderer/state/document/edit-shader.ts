import { companionOf } from '../../../export/glsl/isf/read-isf.ts';
import { type Change, sequence } from '../../../export/graph/commands/change.ts';
import { forkShader, removeSource, setSource } from '../../../export/graph/commands/shader-commands.ts';
import type { Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { nodeOf, type OpenGraph } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { soleNode } from '../editor/selection.ts';
import { apply, endGesture } from './apply.ts';

/** The shader of a node: an ISF file or a technique. */
export interface EditableShader {
  readonly node: string;
  /** The name in `lowering.shader`: `filters/sepia.fs` in the library, `shaders/edge.fs` in the project. */
  readonly name: string;
  readonly text: string;
  /** File name in `shaders/`; null for a shader of the library, which the first edit copies. */
  readonly file: string | null;
}

const SHADER_TYPES = /^(filter|operator|generator|technique)\//;
const OWN_SHADERS = 'shaders/';

/** The shader of the selected node; null if there is none or several nodes are selected. */
export function editableShader(editor: Editor): EditableShader | null {
  const node = soleNode(editor.selection.getState());
  return node === null ? null : shaderOf(editor.document.getState(), node);
}

export function shaderOf(state: OpenGraph, node: string): EditableShader | null {
  const type = nodeOf(state, node)?.type;
  const definition = type === undefined ? undefined : state.library.definition(type);
  if (!definition || !('shader' in definition.lowering) || !SHADER_TYPES.test(definition.type)) return null;
  const name = definition.lowering.shader;
  const text = state.library.shader(name);
  if (text === undefined) return null;
  return { node, name, text, file: name.startsWith(OWN_SHADERS) ? name.slice(OWN_SHADERS.length) : null };
}

/**
 * Sets the text of a node’s shader and updates its interface from the header. A shader of the library is copied into the project
 * first. Successive edits form one undo step until `endGesture`.
 */
export function editShader(editor: Editor, node: string, text: string): boolean {
  const state = editor.document.getState();
  const { base, readShader } = editor.libraries;
  const shader = shaderOf(state, node);
  if (!shader || shader.text === text) return false;
  const set = (file: string) => (before: Project) => setSource(before, { base, readShader, file, text, known: state.library });
  if (shader.file !== null) return apply(editor, `Edit ${shader.file}`, set(shader.file)(state.project), `source ${shader.file}`);

  const forked = forkShader(state.project, { library: state.library, graph: state.graph, node });
  const file = copyOf(forked, state);
  if (file === null) return apply(editor, 'Edit shader', forked);
  return apply(
    editor,
    `Edit ${file}`,
    sequence(state.project, () => forked, set(file)),
    `source ${file}`,
  );
}

/** The file that a fork created; null if the fork was rejected. */
function copyOf({ project }: Change, before: OpenGraph): string | null {
  const made = (name: string) => /\.(fs|glsl)$/.test(name) && !Object.hasOwn(before.project.sources, name);
  return Object.keys(project.sources).find(made) ?? null;
}

/**
 * Sets the text of a project file that belongs to no single node: a chunk (`chunks/NAME.glsl`), which overrides that of the library,
 * or the vertex shader of an ISF file (`NAME.vs`).
 *
 * @param step The file whose edit belongs to the same undo step.
 */
export function editSource(editor: Editor, file: string, text: string, step = file): boolean {
  const { project, library } = editor.document.getState();
  const { base, readShader } = editor.libraries;
  if (getOwn(project.sources, file) === text) return false;
  return apply(editor, `Edit ${file}`, setSource(project, { base, readShader, file, text, known: library }), `source ${step}`);
}

/** Copies a chunk of the library into the project. */
export function copyChunk(editor: Editor, file: string): boolean {
  const text = editor.document.getState().library.shader(file);
  const copied = text !== undefined && editSource(editor, file, text);
  endGesture(editor);
  return copied;
}

/** Name of the vertex shader of a node’s ISF file; null if there is none. */
export function vertexOf(state: OpenGraph, node: string): string | null {
  const name = shaderOf(state, node)?.name;
  const vertex = name === undefined ? undefined : besideOf(state, name);
  return vertex?.file ?? null;
}

/** A vertex shader that changes nothing. */
const VERTEX = `void main() {
  isf_vertShaderInit();
}
`;

/** Whether a vertex shader can be added: the shader is an ISF file without one. */
export function canAddVertex(state: OpenGraph, node: string): boolean {
  return shaderOf(state, node)?.name.endsWith('.fs') === true && vertexOf(state, node) === null;
}

/** Adds a vertex shader to a node’s ISF file. An ISF file of the library is copied into the project in the same step. */
export function addVertex(editor: Editor, node: string): boolean {
  finishTyping(editor);
  const state = editor.document.getState();
  const { base, readShader } = editor.libraries;
  const set = (file: string) => (before: Project) => setSource(before, { base, readShader, file: companionOf(file), text: VERTEX });
  const own = shaderOf(state, node)?.file;
  if (own != null) return apply(editor, `Add ${companionOf(own)}`, set(own)(state.project));
  const forked = forkShader(state.project, { library: state.library, graph: state.graph, node });
  const file = copyOf(forked, state);
  if (file === null) return apply(editor, 'Add vertex shader', forked);
  return apply(
    editor,
    `Add ${companionOf(file)}`,
    sequence(state.project, () => forked, set(file)),
  );
}

/** Removes the vertex shader of a node’s ISF file from the project. */
export function removeVertex(editor: Editor, node: string): boolean {
  finishTyping(editor);
  const state = editor.document.getState();
  const { base, readShader } = editor.libraries;
  const vertex = vertexOf(state, node);
  if (vertex === null) return false;
  const file = projectFileOf(vertex);
  return apply(editor, `Remove ${file}`, removeSource(state.project, { base, readShader, file }));
}

/** The vertex shader of an ISF file, or the ISF file of a vertex shader. */
export function besideOf({ library }: OpenGraph, file: string): { readonly file: string; readonly source: string } | undefined {
  const beside = file.endsWith('.vs') ? file.replace(/\.vs$/, '.fs') : file.replace(/\.fs$/, '.vs');
  const source = beside === file ? undefined : library.shader(beside);
  return source === undefined ? undefined : { file: beside, source };
}

/** Name in the project’s `sources` of a shader (`shaders/NAME` in the library) or chunk. */
export function projectFileOf(name: string): string {
  return name.startsWith(OWN_SHADERS) ? name.slice(OWN_SHADERS.length) : name;
}

/** Copies the shader of a node from the library into the project. */
export function copyShader(editor: Editor, node: string): boolean {
  const { project, library, graph } = editor.document.getState();
  return apply(editor, 'Copy shader into the project', forkShader(project, { library, graph, node }));
}

/** A shader of the library that was copied. */
export interface OriginalShader {
  /** Name in the library, such as `filters/sepia.fs`. */
  readonly name: string;
  readonly text: string;
}

/** The shader that a project shader was copied from: that of the library with the same name, without the number of the copy. */
export function originalOf(editor: Editor, state: OpenGraph, node: string): OriginalShader | null {
  const shader = shaderOf(state, node);
  const type = nodeOf(state, node)?.type;
  if (shader === null || shader.file === null || type === undefined) return null;
  const { base } = editor.libraries;
  for (const candidate of [type, type.replace(/-\d+$/, '')]) {
    const lowering = base.definition(candidate)?.lowering;
    const name = lowering && 'shader' in lowering ? lowering.shader : undefined;
    const text = name === undefined ? undefined : base.shader(name);
    if (name !== undefined && text !== undefined) return { name, text };
  }
  return null;
}

/** Restores the text of the original, as one undo step. */
export function revertShader(editor: Editor, node: string): boolean {
  finishTyping(editor);
  const original = originalOf(editor, editor.document.getState(), node);
  const reverted = original !== null && editShader(editor, node, original.text);
  endGesture(editor);
  return reverted;
}

/** Applies pending text edits as an undo step of their own. */
export function finishTyping(editor: Editor): void {
  for (const finish of editor.unfinished) finish();
}
