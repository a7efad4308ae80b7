import { POSTER_SIZE } from '../../../app/contract/poster-size.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { filesOf, pickFolder, showRefusal } from './files.ts';

/** Exports the current project as a page. Returns true if it was written. */
export async function exportPage(editor: Editor, chosen?: string): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const out = chosen ?? (await pickFolder(editor, 'export'));
  if (out === null) return false;
  editor.ui.setState({ exporting: { handle: open.handle, text: 'Exporting…', cancelled: false }, dialog: null });
  try {
    const files = filesOf(editor);
    const refused = editor.preview.getState().shaderDiagnostics;
    if (hasErrors(refused)) return reportProblems(editor, refused);
    const poster = await drawPoster(editor);
    if (isCancelled(editor)) return reportCanceled(editor);
    const result = await editor.host.call('export.run', { handle: open.handle, files, out, poster });
    const diagnostics = result.diagnostics as readonly Diagnostic[];
    editor.ui.setState({ exportDiagnostics: diagnostics });
    if (hasErrors(diagnostics)) return reportProblems(editor, diagnostics);
    // Canceled by the user, or because the project was closed.
    if (!result.ok) return reportCanceled(editor);
    addToast(editor.ui, { tone: 'success', text: `Exported to ${result.out}.`, detail: `${formatBytes(result.bytes)} in total.` });
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  } finally {
    editor.ui.setState({ exporting: null });
  }
}

/** Cancels the export. An earlier export is not changed. */
export async function cancelExport(editor: Editor): Promise<void> {
  const { exporting } = editor.ui.getState();
  if (exporting === null || exporting.cancelled) return;
  editor.ui.setState({ exporting: { ...exporting, text: 'Canceling…', cancelled: true } });
  // A frame render checks `cancelled` between two frames.
  if (exporting.frames) return;
  try {
    await editor.host.call('export.cancel', { handle: exporting.handle });
  } catch (error) {
    showRefusal(editor, error);
  }
}

/** Shows the progress that the host reports. */
export function showExportProgress({ ui }: Editor, handle: string, text: string): void {
  const { exporting } = ui.getState();
  if (exporting?.handle === handle && !exporting.cancelled) ui.setState({ exporting: { ...exporting, text } });
}

/** Renders the poster from the current view of the preview. Without one, the page is exported anyway. */
async function drawPoster({ posters, ui }: Editor): Promise<Uint8Array<ArrayBuffer> | null> {
  ui.setState(({ exporting }) => ({ exporting: exporting && { ...exporting, text: 'Rendering the poster…' } }));
  return (await posters.take?.(POSTER_SIZE)) ?? null;
}

function isCancelled({ ui }: Editor): boolean {
  return ui.getState().exporting?.cancelled === true;
}

function reportCanceled(editor: Editor): false {
  addToast(editor.ui, { tone: 'info', text: 'Export canceled.', detail: 'Nothing was written.' });
  return false;
}

function reportProblems(editor: Editor, diagnostics: readonly Diagnostic[]): false {
  const first = diagnostics.find((diagnostic) => diagnostic.severity === 'error');
  addToast(editor.ui, {
    tone: 'error',
    text: first?.message ?? 'The page could not be exported.',
    detail: first?.fix ?? 'The Problems panel lists the reasons.',
  });
  editor.ui.setState({ bottom: 'problems' });
  return false;
}

function formatBytes(bytes: number): string {
  return bytes < 1024 * 1024 ? `${Math.round(bytes / 1024)} kB` : `${(bytes / 1024 / 1024).toFixed(1)} MB`;
}
