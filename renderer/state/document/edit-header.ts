import { type HeaderPath, type HeaderValue, moveInHeader, setInHeader } from '../../../export/glsl/language/header-edits.ts';
import { renameAt } from '../../../export/glsl/language/rename.ts';
import { readShaderDocument } from '../../../export/glsl/language/shader-document.ts';
import { applyEdits } from '../../../export/glsl/language/source-text.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { endGesture } from './apply.ts';
import { editShader, finishTyping, shaderOf } from './edit-shader.ts';

/**
 * Edits the header of a node’s shader outside the text editor, as one undo step. Returns false if the header is invalid or the edit
 * is rejected.
 */
export function editHeader(editor: Editor, node: string, path: HeaderPath, value: HeaderValue | undefined): boolean {
  return editText(editor, node, (text) => setInHeader(text, path, value));
}

export function moveInput(editor: Editor, node: string, from: number, to: number): boolean {
  return editText(editor, node, (text) => moveInHeader(text, ['INPUTS'], from, to));
}

/** Renames an input in the header and the code. Wires and params keep their connection to it. */
export function renameInput(editor: Editor, node: string, from: string, to: string): boolean {
  return editText(editor, node, (text, file) => {
    const options = { chunkOf: chunkOf(editor) };
    const document = readShaderDocument(text, file, options);
    const place = document.headerNames.find(({ role, name }) => role === 'input' && name === from)?.range.start;
    const renamed = place && renameAt(document, place, to, options);
    if (renamed?.ok) return applyEdits(text, renamed.edits);
    if (renamed) addToast(editor.ui, { tone: 'warning', text: renamed.reason });
    return null;
  });
}

/** Looks up the text of a chunk by name. */
export function chunkOf(editor: Editor): (name: string) => string | undefined {
  return (name) => editor.document.getState().library.shader(`chunks/${name}.glsl`);
}

function editText(editor: Editor, node: string, edit: (text: string, file: string) => string | null): boolean {
  finishTyping(editor);
  const shader = shaderOf(editor.document.getState(), node);
  const text = shader && edit(shader.text, shader.name);
  const edited = text !== null && editShader(editor, node, text);
  endGesture(editor);
  return edited;
}
