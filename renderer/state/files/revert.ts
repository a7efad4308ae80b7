import { replaceProject } from '../../../export/graph/commands/project-info.ts';
import type { Project } from '../../../export/graph/project.ts';
import { apply, endGesture, projectAtStep, savedStep } from '../document/apply.ts';
import { finishTyping } from '../document/edit-shader.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { closeProject, readProject, showRefusal } from './files.ts';

/** Goes back to the saved version, as one undo step. */
export function revertToSaved(editor: Editor): Promise<void> {
  return editor.fileWork(async () => {
    finishTyping(editor);
    const state = editor.document.getState();
    const step = savedStep(state);
    const saved = step === null ? await readSaved(editor) : projectAtStep(state, step);
    if (saved === null) return;
    finishTyping(editor);
    endGesture(editor);
    apply(editor, 'Revert to saved', replaceProject(editor.document.getState().project, saved));
    editor.document.setState(({ history, savedState }) => {
      const last = history.past.at(-1);
      if (step === null || last === undefined) return { savedState: history.state };
      // Equal numbers mean equal projects, so that the earlier step is still known as the saved one.
      return { history: { ...history, state: savedState, past: [...history.past.slice(0, -1), { ...last, after: savedState }] } };
    });
    addToast(editor.ui, { tone: 'info', text: 'Reverted to the saved version.', detail: 'Undo brings the changes back.' });
  });
}

/** The version on disk, for a saved version that the history no longer has; null if it cannot be read. */
async function readSaved(editor: Editor): Promise<Project | null> {
  const { open } = editor.document.getState();
  if (open === null) return null;
  try {
    const opened = await editor.host.call('project.open', { path: open.displayPath });
    await closeProject(editor, opened.handle, false);
    return readProject(editor, opened.files)?.project ?? null;
  } catch (error) {
    showRefusal(editor, error);
    return null;
  }
}
