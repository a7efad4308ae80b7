import type { HostEvent } from '../../../app/contract/contract.ts';
import { sequence } from '../../../export/graph/commands/change.ts';
import { setSource } from '../../../export/graph/commands/shader-commands.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { apply } from '../document/apply.ts';
import { finishTyping } from '../document/edit-shader.ts';
import { isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { loadExternalChanges, openConflictDialog } from './files.ts';

type ShadersChanged = Extract<HostEvent, { kind: 'shaders-changed-outside' }>;

/**
 * Applies shaders that another program saved, as one undo step. They become read-only here until the user edits them again. If one
 * has unsaved changes, asks which version to keep.
 */
export function applyExternalShaders(editor: Editor, { handle, from, revision, shaders }: ShadersChanged): void {
  finishTyping(editor);
  const state = editor.document.getState();
  const { open, project, library } = state;
  if (open === null || open.handle !== handle) return;
  const gone = shaders.some(({ text }) => text === null);
  if (open.revision !== from || gone) {
    void loadExternalChanges(editor);
    return;
  }
  const touched = shaders.some(({ file, before, text }) => ![before, text].includes(getOwn(project.sources, file) ?? null));
  if (touched) {
    openConflictDialog(editor);
    return;
  }
  const wasClean = !isDirty(state);
  const { base, readShader } = editor.libraries;
  const change = sequence(
    project,
    ...shaders.map(
      ({ file, text }) =>
        (before: typeof project) =>
          setSource(before, { base, readShader, file, text: text ?? '', known: library }),
    ),
  );
  const files = shaders.map(({ file }) => file);
  const key = `outside ${files.join(' ')}`;
  if (!apply(editor, `Update ${files.join(', ')} from disk`, change, key)) return;
  // Changes of the graph that follow from a header are not saved yet.
  const isSaved = wasClean && change.project.graphs === project.graphs;
  editor.document.setState((now) => ({
    open: now.open && { ...now.open, revision },
    ...(isSaved ? { savedState: now.history.state } : {}),
  }));
  editor.ui.setState(({ outside }) => ({ outside: [...new Set([...outside, ...files])] }));
}

/** Makes the shader editable here again. Saves of other programs are still applied. */
export function editHere(editor: Editor, file: string): void {
  editor.ui.setState(({ outside }) => ({ outside: outside.filter((other) => other !== file) }));
}
