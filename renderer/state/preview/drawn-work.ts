import type { Program } from '../../../export/program/program.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { FrameRenderRequest } from '../../preview-protocol.ts';
import type { Editor, FrameRenderAnswer } from '../editor/editor.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';

/** What a hidden page draws, with the params that changed after the program was compiled. */
export interface ReadyProgram {
  readonly program: Program;
  readonly values: FrameRenderRequest['values'];
}

/**
 * The program of the document as the preview plays it. Null, with a message, while it is being compiled or has errors.
 *
 * @param problems The message about errors.
 */
export function readyProgram(editor: Editor, problems: string): ReadyProgram | null {
  const { program, programRevision, laterValues, diagnostics, busy } = editor.compile.getState();
  if (programRevision !== editor.document.getState().revision && busy) {
    addToast(editor.ui, { tone: 'info', text: 'The project is still compiling. Try again in a moment.' });
    return null;
  }
  if (program === null || hasErrors(diagnostics) || hasErrors(editor.preview.getState().shaderDiagnostics)) {
    addToast(editor.ui, { tone: 'error', text: problems, detail: 'The Problems panel lists them.' });
    editor.ui.setState({ bottom: 'problems' });
    return null;
  }
  return { program, values: laterValues.map(({ node, param, value }) => ({ node, param, value })) };
}

/** A failure of the page that draws. */
class DrawnWorkError extends Error {
  readonly diagnostic: Diagnostic;

  constructor(diagnostic: Diagnostic) {
    super(diagnostic.message);
    this.diagnostic = diagnostic;
  }
}

/** The answer of the page. Throws what `showFailure` shows if the page failed. */
export function unwrap(answer: FrameRenderAnswer | null): Exclude<FrameRenderAnswer, { kind: 'render-failed' }> | null {
  if (answer?.kind === 'render-failed') throw new DrawnWorkError(answer.diagnostic);
  return answer;
}

/** Shows a failure of the page or a refusal of the host. */
export function showFailure(editor: Editor, error: unknown): void {
  if (error instanceof DrawnWorkError) toastDiagnostic(editor.ui, error.diagnostic);
  else showRefusal(editor, error);
}

/** Resolves when the user cancels, also during a frame. */
export function cancellation({ ui }: Editor) {
  let dispose = () => {};
  const promise = new Promise<null>((resolve) => {
    dispose = ui.subscribe(({ exporting }) => {
      if (exporting?.cancelled) resolve(null);
    });
  });
  return { promise, dispose };
}

/** Shows progress, unless the user canceled. */
export function showProgress({ ui }: Editor, text: string): void {
  ui.setState(({ exporting }) => ({ exporting: exporting && !exporting.cancelled ? { ...exporting, text } : exporting }));
}

export function isCancelled({ ui }: Editor): boolean {
  return ui.getState().exporting?.cancelled === true;
}
