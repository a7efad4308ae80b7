import { inTurn } from '../../export/graph/commands/change.ts';
import { forkShader, setSource } from '../../export/graph/commands/sources.ts';
import { apply } from './apply.ts';
import { nodeOf, type OpenGraph } from './document.ts';
import type { Editor } from './editor.ts';
import { soleNode } from './selection.ts';

/** The source behind a node: an ISF file or a technique. */
export interface EditableShader {
  readonly node: string;
  /** As `lowering.shader` names it: `filters/sepia.fs` of the library, `shaders/edge.fs` of the project. */
  readonly name: string;
  readonly text: string;
  /** In `shaders/`; null for one of the library, which the first edit copies. */
  readonly file: string | null;
}

const SHADER_TYPES = /^(filter|operator|generator|technique)\//;
const OWN_SHADERS = 'shaders/';

/** The shader of the one selected node; null where there is none to edit. */
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
 * Takes over the text of a node's shader, with all that follows from its header. A shader of the library is copied into the
 * project in the same step. Typing is one step until `endGesture`.
 */
export function editShader(editor: Editor, node: string, text: string): boolean {
  const state = editor.document.getState();
  const { base, readShader } = editor.libraries;
  const shader = shaderOf(state, node);
  if (!shader || shader.text === text) return false;
  const set = (file: string) => (before: typeof state.project) => setSource(before, { base, readShader, file, text });
  if (shader.file !== null) return apply(editor, `Edit ${shader.file}`, set(shader.file)(state.project), `source ${shader.file}`);

  const forked = forkShader(state.project, { library: state.library, graph: state.graph, node });
  const [file] = Object.keys(forked.project.sources).filter(
    (name) => /\.(fs|glsl)$/.test(name) && !Object.hasOwn(state.project.sources, name),
  );
  if (file === undefined) return apply(editor, 'Edit shader', forked);
  return apply(
    editor,
    `Edit ${file}`,
    inTurn(state.project, () => forked, set(file)),
    `source ${file}`,
  );
}
