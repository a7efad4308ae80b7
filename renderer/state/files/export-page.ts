import { POSTER_SIZE } from '../../../app/contract/poster-size.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { filesOf, pickFolder, showRefusal } from './files.ts';

/** Writes the standalone page, of the project as it stands. True where it was written. */
export async function exportPage(editor: Editor, chosen?: string): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const out = chosen ?? (await pickFolder(editor, 'export'));
  if (out === null) return false;
  editor.ui.setState({ exporting: { handle: open.handle, text: 'Exporting…', cancelled: false }, dialog: null });
  try {
    const files = filesOf(editor);
    const refused = editor.preview.getState().shaderDiagnostics;
    if (hasErrors(refused)) return tellProblems(editor, refused);
    const poster = await drawPoster(editor);
    if (isCancelled(editor)) return tellCancelled(editor);
    const result = await editor.host.call('export.run', { handle: open.handle, files, out, poster });
    const diagnostics = result.diagnostics as readonly Diagnostic[];
    editor.ui.setState({ exportDiagnostics: diagnostics });
    if (hasErrors(diagnostics)) return tellProblems(editor, diagnostics);
    // By the person, or by the end of the project that it was of.
    if (!result.ok) return tellCancelled(editor);
    addToast(editor.ui, { tone: 'success', text: `Exported to ${result.out}.`, detail: `${formatBytes(result.bytes)} in all.` });
    return true;
  } catch (error) {
    showRefusal(editor, error);
    return false;
  } finally {
    editor.ui.setState({ exporting: null });
  }
}

/** Nothing is written then, and an earlier export stays. */
export async function cancelExport(editor: Editor): Promise<void> {
  const { exporting } = editor.ui.getState();
  if (exporting === null || exporting.cancelled) return;
  editor.ui.setState({ exporting: { ...exporting, text: 'Cancelling…', cancelled: true } });
  // The loop that draws the frames reads `cancelled` between two frames.
  if (exporting.frames) return;
  try {
    await editor.host.call('export.cancel', { handle: exporting.handle });
  } catch (error) {
    showRefusal(editor, error);
  }
}

/** What the host says that it is at. */
export function showExportProgress({ ui }: Editor, handle: string, text: string): void {
  const { exporting } = ui.getState();
  if (exporting?.handle === handle && !exporting.cancelled) ui.setState({ exporting: { ...exporting, text } });
}

/** What the preview shows, which is what the person means the page to look like; null is no reason not to export. */
async function drawPoster({ posters, ui }: Editor): Promise<Uint8Array<ArrayBuffer> | null> {
  ui.setState(({ exporting }) => ({ exporting: exporting && { ...exporting, text: 'Taking the poster’s picture…' } }));
  return (await posters.take?.(POSTER_SIZE)) ?? null;
}

function isCancelled({ ui }: Editor): boolean {
  return ui.getState().exporting?.cancelled === true;
}

function tellCancelled(editor: Editor): false {
  addToast(editor.ui, { tone: 'info', text: 'The export was cancelled.', detail: 'Nothing was written.' });
  return false;
}

function tellProblems(editor: Editor, diagnostics: readonly Diagnostic[]): false {
  const first = diagnostics.find((diagnostic) => diagnostic.severity === 'error');
  addToast(editor.ui, {
    tone: 'error',
    text: first?.message ?? 'The page could not be exported.',
    detail: first?.fix ?? 'All reasons are under Problems.',
  });
  editor.ui.setState({ bottom: 'problems' });
  return false;
}

function formatBytes(bytes: number): string {
  return bytes < 1024 * 1024 ? `${Math.round(bytes / 1024)} kB` : `${(bytes / 1024 / 1024).toFixed(1)} MB`;
}
