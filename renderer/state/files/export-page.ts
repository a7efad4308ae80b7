import { HostError } from '../../../app/contract/host-error.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast, type DialogRequest, type ExportedPage, type ExportSettings } from '../editor/ui.ts';
import { base64Of } from './base64.ts';
import { byteText } from './byte-text.ts';
import { filesOf, showRefusal } from './files.ts';
import { nextPoster } from './poster.ts';

/** Opens the dialog for an export, without the errors of an earlier one. */
export function openExportDialog({ ui }: Editor): void {
  ui.setState({ dialog: { kind: 'export' }, ...(ui.getState().exporting === null && { exportErrors: [] }) });
}

/** Whether a dialog shows the progress and the errors of an export. */
export function isExportDialog(dialog: DialogRequest | null): boolean {
  return dialog?.kind === 'export' || dialog?.kind === 'exported';
}

/** The page of the last export of the open project; null if there is none. */
export function lastExport({ ui, document }: Editor): ExportedPage | null {
  const { exported } = ui.getState();
  return exported !== null && exported.handle === document.getState().open?.handle ? exported : null;
}

/**
 * Exports the current project as a page, with changed settings. Returns true if it was written. Result and errors are shown in the
 * dialog of the export, if it is open.
 *
 * @param shown The poster that the dialog shows; null: the chosen one, or one of the current view.
 */
export async function exportPage(
  editor: Editor,
  changed: Partial<ExportSettings>,
  shown: Uint8Array<ArrayBuffer> | null = null,
): Promise<boolean> {
  const { open, project } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const settings = { ...editor.ui.getState().exportSettings, ...changed };
  const { out, singleFile, offline } = settings;
  editor.ui.setState({
    exporting: { handle: open.handle, text: 'Exporting…', cancelled: false },
    exportErrors: [],
    exportSettings: settings,
  });
  try {
    const files = filesOf(editor);
    const refused = editor.preview.getState().shaderDiagnostics;
    if (hasErrors(refused)) return reportErrors(editor, refused);
    const poster = shown ?? (await posterOf(editor));
    if (isCancelled(editor)) return reportCanceled(editor);
    const address = readAddress(settings.address);
    const asked = { handle: open.handle, files, out, poster, singleFile, offline, address };
    const { ok, report, ...result } = await editor.host.call('export.run', asked);
    const diagnostics = result.diagnostics as readonly Diagnostic[];
    editor.ui.setState({ exportDiagnostics: diagnostics });
    if (hasErrors(diagnostics)) return reportErrors(editor, diagnostics);
    // Canceled by the user, or because the project was closed.
    if (!ok || report === null) return reportCanceled(editor);
    const { handle } = open;
    showResult(editor, { handle, title: project.title, settings, report, poster: poster && `data:image/jpeg;base64,${base64Of(poster)}` });
    return true;
  } catch (error) {
    if (!(error instanceof HostError)) throw error;
    return reportErrors(editor, [error.diagnostic as Diagnostic]);
  } finally {
    editor.ui.setState({ exporting: null });
  }
}

/** The address as a URL; null if it is empty or no address of the web. `https://` may be left out. */
export function readAddress(typed: string): string | null {
  const text = typed.trim();
  if (text === '') return null;
  const whole = /^[a-z][a-z0-9+.-]*:\/\//i.test(text) ? text : `https://${text}`;
  const url = URL.canParse(whole) ? new URL(whole) : null;
  return url !== null && /^https?:$/.test(url.protocol) ? url.href : null;
}

/** Opens the last exported page in the browser. */
export async function visitExport(editor: Editor, openTab: (url: string) => void): Promise<void> {
  const shown = await showExport(editor, true);
  if (shown !== null && !shown.opened) openTab(shown.url);
}

/** Copies the address of the published page; without one, its address on this machine. Returns what there is to say about it. */
export async function copyExportAddress(editor: Editor): Promise<string | null> {
  const published = readAddress(editor.ui.getState().exportSettings.address);
  const url = published ?? (await showExport(editor, false))?.url;
  if (url === undefined) return null;
  try {
    await editor.clipboard.write(url);
    return `Copied ${url}`;
  } catch {
    return `The browser denies access to the clipboard. The address is ${url}`;
  }
}

async function showExport(editor: Editor, open: boolean): Promise<{ readonly url: string; readonly opened: boolean } | null> {
  const handle = lastExport(editor)?.handle;
  if (handle === undefined) return null;
  try {
    return await editor.host.call('export.show', { handle, open });
  } catch (error) {
    if (!(error instanceof HostError)) throw error;
    reportErrors(editor, [error.diagnostic as Diagnostic]);
    return null;
  }
}

/** Cancels the export. An earlier export is not changed. */
export async function cancelExport(editor: Editor): Promise<void> {
  const { exporting } = editor.ui.getState();
  if (exporting === null || exporting.cancelled) return;
  editor.ui.setState({ exporting: { ...exporting, text: 'Canceling…', cancelled: true } });
  // A frame render or an acquisition watches `cancelled` itself.
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

/** The chosen poster, or one of the current view of the preview. Without one, the page is exported anyway. */
function posterOf(editor: Editor): Promise<Uint8Array<ArrayBuffer> | null> {
  editor.ui.setState(({ exporting }) => ({ exporting: exporting && { ...exporting, text: 'Rendering the poster…' } }));
  return nextPoster(editor, editor.document.getState().project.page.poster);
}

function isCancelled({ ui }: Editor): boolean {
  return ui.getState().exporting?.cancelled === true;
}

/** Shows the result in the dialog of the export; in a message if it was closed meanwhile. */
function showResult({ ui }: Editor, exported: ExportedPage): void {
  ui.setState({ exported });
  if (isExportDialog(ui.getState().dialog)) {
    ui.setState({ dialog: { kind: 'exported' } });
    return;
  }
  const detail = `${byteText(exported.report.bytes.raw)} in total. File > Exported page shows more.`;
  addToast(ui, { tone: 'success', text: `Exported to ${exported.settings.out}.`, detail });
}

function reportCanceled({ ui }: Editor): false {
  if (!isExportDialog(ui.getState().dialog)) addToast(ui, { tone: 'info', text: 'Export canceled.', detail: 'Nothing was written.' });
  return false;
}

/** Shows the errors in the dialog of the export; in a message if it was closed meanwhile. */
function reportErrors({ ui }: Editor, diagnostics: readonly Diagnostic[]): false {
  const errors = diagnostics.filter(({ severity }) => severity === 'error');
  ui.setState({ exportErrors: errors });
  if (isExportDialog(ui.getState().dialog)) return false;
  addToast(ui, {
    tone: 'error',
    text: errors[0]?.message ?? 'The page could not be exported.',
    detail: errors[0]?.fix ?? 'The Problems panel lists the reasons.',
  });
  ui.setState({ bottom: 'problems' });
  return false;
}
