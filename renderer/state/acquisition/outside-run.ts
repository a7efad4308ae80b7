import type { HostEvent } from '../../../app/contract/contract.ts';
import { HostError } from '../../../app/contract/host-error.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast, type Toast, type ToolRun, toastDiagnostic } from '../editor/ui.ts';
import { cancellation, isCancelled } from '../preview/drawn-work.ts';

/** Work of the host with a program of others. */
export interface OutsideWork<Done> {
  /** The dialog that shows it. */
  readonly dialog: ToolRun['dialog'];
  /** What is shown until the first progress. */
  readonly begin: Pick<ToolRun, 'step'> & { readonly text: string };
  /** What is told after a cancel. */
  readonly canceled: Pick<Toast, 'text' | 'detail'>;
  readonly run: (handle: string) => Promise<Done>;
  /** Shows the result, at the path in the project. */
  readonly show: (path: string, done: Done) => Promise<void>;
}

const MOST_LINES = 500;

/**
 * Works with a program of others, one at a time. A failure is kept in the state for the dialog, from which the work can be repeated.
 *
 * @returns Whether it succeeded.
 */
export async function runOutside<Done extends { readonly path: string | null }>(editor: Editor, work: OutsideWork<Done>): Promise<boolean> {
  const { dialog, begin, canceled, run, show } = work;
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const { handle } = open;
  editor.ui.setState({
    exporting: { handle, text: begin.text, cancelled: false, frames: true },
    toolRun: { handle, dialog, step: begin.step, lines: [], error: null },
  });
  const stopped = cancellation(editor);
  void stopped.promise.then(() => editor.host.call('tool.cancel', { handle }).catch(() => {}));
  try {
    const done = await run(handle);
    if (done.path === null || isCancelled(editor) || editor.document.getState().open?.handle !== handle) {
      editor.ui.setState({ toolRun: null });
      addToast(editor.ui, { tone: 'info', ...canceled });
      return false;
    }
    editor.ui.setState({ toolRun: null, ...(editor.ui.getState().dialog?.kind === dialog && { dialog: null }) });
    await show(done.path, done);
    return true;
  } catch (error) {
    const diagnostic = diagnosticOf(error);
    editor.ui.setState(({ toolRun }) => ({ toolRun: toolRun && { ...toolRun, error: diagnostic } }));
    // The dialog shows it itself.
    if (editor.ui.getState().dialog?.kind !== dialog) toastDiagnostic(editor.ui, diagnostic);
    return false;
  } finally {
    stopped.dispose();
    editor.ui.setState({ exporting: null });
  }
}

/** Shows what the host reports. */
export function showToolEvent({ ui }: Editor, event: Extract<HostEvent, { kind: `tool-${string}` }>): void {
  const { toolRun, exporting } = ui.getState();
  if (toolRun === null || toolRun.handle !== event.handle || toolRun.error !== null) return;
  if (event.kind === 'tool-log') {
    ui.setState({ toolRun: { ...toolRun, lines: [...toolRun.lines, ...event.lines].slice(-MOST_LINES) } });
    return;
  }
  ui.setState({
    toolRun: { ...toolRun, step: event.step },
    exporting: exporting && !exporting.cancelled ? { ...exporting, text: event.text } : exporting,
  });
}

/** The answer of the host to a question, or why there is none; null if no project is open. */
export async function asked<T>(editor: Editor, question: (handle: string) => Promise<T>): Promise<T | Diagnostic | null> {
  const handle = editor.document.getState().open?.handle;
  if (handle === undefined) return null;
  try {
    return await question(handle);
  } catch (error) {
    return diagnosticOf(error);
  }
}

function diagnosticOf(error: unknown): Diagnostic {
  if (error instanceof HostError) return error.diagnostic as Diagnostic;
  throw error;
}
