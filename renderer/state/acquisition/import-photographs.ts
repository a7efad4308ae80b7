import type { HostEvent, HostOutput } from '../../../app/contract/contract.ts';
import { HostError } from '../../../app/contract/host-error.ts';
import { makeAssetId } from '../../../export/graph/document-names.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { nameOf, refreshAssetFiles } from '../files/edit-assets.ts';
import { placeAsset } from '../graph/place-asset.ts';
import { cancellation, isCancelled } from '../preview/drawn-work.ts';

export interface PhotographsRequest {
  /** Absolute path. */
  readonly folder: string;
  readonly name: string;
  /** Path of COLMAP; empty: that of the host. */
  readonly colmap: string;
  readonly oneCamera: boolean;
}

/** What is in a folder of photographs, or why it cannot be read. */
export type FolderLook = HostOutput<'photographs.look'> | Diagnostic;

const MOST_LINES = 500;

/** Looks into a folder of photographs. */
export async function lookIntoFolder(editor: Editor, folder: string, colmap: string): Promise<FolderLook | null> {
  const handle = editor.document.getState().open?.handle;
  if (handle === undefined) return null;
  try {
    return await editor.host.call('photographs.look', { handle, folder, colmap: colmap || null });
  } catch (error) {
    return diagnosticOf(error);
  }
}

/**
 * Imports a folder of photographs as a capture, and shows it in the graph. Where the folder has no cameras, the host finds them with COLMAP.
 * A failure is kept in the state for the dialog, which continues the import.
 *
 * @param place Position of the new node in canvas units.
 * @returns Whether the capture was added.
 */
export async function importPhotographs(
  editor: Editor,
  { folder, name, colmap, oneCamera }: PhotographsRequest,
  place: Place,
): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const { handle } = open;
  editor.ui.setState({
    exporting: { handle, text: 'Reading photographs…', cancelled: false, frames: true },
    photographs: { handle, step: 'features', lines: [], error: null },
  });
  const stopped = cancellation(editor);
  void stopped.promise.then(() => editor.host.call('photographs.cancel', { handle }).catch(() => {}));
  try {
    const done = await editor.host.call('photographs.import', { handle, folder, name, colmap: colmap || null, oneCamera });
    if (done.path === null || isCancelled(editor) || editor.document.getState().open?.handle !== handle) {
      editor.ui.setState({ photographs: null });
      addToast(editor.ui, {
        tone: 'info',
        text: 'Import of photographs canceled.',
        detail: 'Importing the same folder continues where it was.',
      });
      return false;
    }
    editor.ui.setState({ photographs: null, ...(editor.ui.getState().dialog?.kind === 'photographs' && { dialog: null }) });
    await show(editor, done.path, done, place);
    return true;
  } catch (error) {
    const diagnostic = diagnosticOf(error);
    editor.ui.setState(({ photographs }) => ({ photographs: photographs && { ...photographs, error: diagnostic } }));
    // The dialog shows it itself.
    if (editor.ui.getState().dialog?.kind !== 'photographs') toastDiagnostic(editor.ui, diagnostic);
    return false;
  } finally {
    stopped.dispose();
    editor.ui.setState({ exporting: null });
  }
}

/** Shows what the host reports. */
export function showPhotographsEvent({ ui }: Editor, event: Extract<HostEvent, { kind: `photographs-${string}` }>): void {
  const { photographs, exporting } = ui.getState();
  if (photographs === null || photographs.handle !== event.handle || photographs.error !== null) return;
  if (event.kind === 'photographs-log') {
    ui.setState({ photographs: { ...photographs, lines: [...photographs.lines, ...event.lines].slice(-MOST_LINES) } });
    return;
  }
  ui.setState({
    photographs: { ...photographs, step: event.step },
    exporting: exporting && !exporting.cancelled ? { ...exporting, text: event.text } : exporting,
  });
}

async function show(
  editor: Editor,
  path: string,
  { found, photographs, isRough, start, diagnostics }: HostOutput<'photographs.import'>,
  place: Place,
): Promise<void> {
  await editor.fileWork(async () => {
    const id = makeAssetId(editor.document.getState().project, path.slice(0, path.lastIndexOf('/')), editor.random);
    const asset = { path, kind: 'capture' } as const;
    const node = placeAsset(editor, { id, asset, label: `Add ${nameOf(path)}`, start }, place);
    if (node !== null) selectOnly(editor.selection, [node]);
  });
  await refreshAssetFiles(editor);
  for (const warning of diagnostics as readonly Diagnostic[]) toastDiagnostic(editor.ui, warning);
  const count =
    found === photographs ? `${found} photographs.` : `${found} of ${photographs} photographs: COLMAP found no cameras for the others.`;
  addToast(editor.ui, {
    tone: 'success',
    text: `Added ${nameOf(path)}.`,
    detail: `${count}${isRough ? ' Its mesh is rough, because COLMAP needs CUDA for depth.' : ''} Set its true size in the inspector.`,
  });
}

function diagnosticOf(error: unknown): Diagnostic {
  if (error instanceof HostError) return error.diagnostic as Diagnostic;
  throw error;
}
