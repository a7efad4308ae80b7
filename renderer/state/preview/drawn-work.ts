import type { Program } from '../../../export/program/program.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { FrameRenderRequest } from '../../preview-protocol.ts';
import type { Editor, FrameRenderAnswer, FrameRenderQuestion } from '../editor/editor.ts';
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

/** What work by a page of its own needs. */
export interface DrawnWork<Done> {
  /** Handle of the project. */
  readonly handle: string;
  /** Shown until the first progress. */
  readonly text: string;
  /** Deletes what the host has of unfinished work. Called at the end if `isOnHost` is set. */
  readonly cancelOnHost: () => Promise<unknown>;
  /** Tells that the user canceled, or closed the project. */
  readonly reportCanceled: () => void;
  /** Does the work. */
  readonly run: (page: DrawingPage) => Promise<Done | typeof CANCELED>;
}

/** The page while it works. */
export interface DrawingPage {
  /** Sends a message to the page; resolves to null if the user cancels. Throws if the page fails. */
  ask(message: FrameRenderQuestion): Promise<DrawnAnswer | null>;
  /** Resolves when the user cancels. */
  readonly canceled: Promise<null>;
  /** Whether the host has unfinished work. */
  isOnHost: boolean;
}

/** The result of work that the user canceled. */
export const CANCELED = Symbol('canceled');

/**
 * Works with a hidden page that draws, until it is done, fails or is canceled; shows failures, and tells that the user canceled. One work at a
 * time.
 *
 * @returns What `run` returns; null if the user canceled, it failed, or there is no such page.
 */
export async function playDrawnWork<Done>(editor: Editor, { handle, text, cancelOnHost, reportCanceled, run }: DrawnWork<Done>) {
  const link = editor.renderPage.open?.();
  if (!link) return null;
  editor.ui.setState({ exporting: { handle, text, cancelled: false, frames: true } });
  const stopped = cancellation(editor);
  const page: DrawingPage = {
    ask: async (message) => unwrap(await Promise.race([link.ask(message), stopped.promise])),
    canceled: stopped.promise,
    isOnHost: false,
  };
  try {
    const done = await run(page);
    if (done !== CANCELED) return done;
    reportCanceled();
    return null;
  } catch (error) {
    // The host ends the work of a project that is closed.
    if (editor.document.getState().open?.handle === handle) showFailure(editor, error);
    else reportCanceled();
    return null;
  } finally {
    stopped.dispose();
    link.close();
    editor.ui.setState({ exporting: null });
    if (page.isOnHost) await cancelOnHost().catch((error: unknown) => showRefusal(editor, error));
  }
}

/** A failure of the page that draws. */
class DrawnWorkError extends Error {
  readonly diagnostic: Diagnostic;

  constructor(diagnostic: Diagnostic) {
    super(diagnostic.message);
    this.diagnostic = diagnostic;
  }
}

type DrawnAnswer = Exclude<FrameRenderAnswer, { kind: 'render-failed' }>;

/** The answer of the page. Throws what `showFailure` shows if the page failed. */
function unwrap(answer: FrameRenderAnswer | null): DrawnAnswer | null {
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
