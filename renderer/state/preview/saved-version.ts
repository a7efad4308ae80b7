import { projectAtStep, savedStep } from '../document/apply.ts';
import { finishTyping } from '../document/edit-shader.ts';
import { endCandidate } from '../editor/candidate-state.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';

/** Shows the saved version in the preview, or the document again. */
export function toggleSavedVersion(editor: Editor): void {
  if (editor.candidate.getState().project !== null) {
    endCandidate(editor);
    return;
  }
  finishTyping(editor);
  const state = editor.document.getState();
  const step = savedStep(state);
  if (step === null) addToast(editor.ui, { tone: 'info', text: 'The saved version is no longer in the history.' });
  else if (step !== state.history.past.length) editor.candidate.setState({ project: projectAtStep(state, step) });
}
