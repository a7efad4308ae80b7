import type { HostInput, HostOutput } from '../../../app/contract/contract.ts';
import { makeAssetId } from '../../../export/graph/document-names.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { nameOf, refreshAssetFiles } from '../files/edit-assets.ts';
import { placeAsset } from '../graph/place-asset.ts';
import { showCaptureReport } from './capture-report.ts';
import { asked, runOutside } from './outside-run.ts';

export interface PhotographsRequest
  extends Pick<HostInput<'photographs.import'>, 'oneCamera' | 'maxSidePx' | 'up' | 'metersPerUnit' | 'depth'> {
  /** Absolute path. */
  readonly folder: string;
  readonly name: string;
  /** Path of COLMAP; empty: that of the host. */
  readonly colmap: string;
}

/** What is in a folder of photographs, or why it cannot be read. */
export type FolderLook = HostOutput<'photographs.look'> | Diagnostic;

/** Looks into a folder of photographs. */
export function lookIntoFolder(editor: Editor, folder: string, colmap: string): Promise<FolderLook | null> {
  return asked(editor, (handle) => editor.host.call('photographs.look', { handle, folder, colmap: colmap || null }));
}

/**
 * Imports a folder of photographs as a capture, and shows it in the graph. Where the folder has no cameras, the host finds them with COLMAP.
 *
 * @param place Position of the new node in canvas units.
 * @returns Whether the capture was added.
 */
export function importPhotographs(editor: Editor, { colmap, ...request }: PhotographsRequest, place: Place): Promise<boolean> {
  return runOutside(editor, {
    dialog: 'photographs',
    begin: { step: 'features', text: 'Reading photographs…' },
    canceled: { text: 'Import of photographs canceled.', detail: 'Importing the same folder continues where it was.' },
    run: (handle) => editor.host.call('photographs.import', { handle, ...request, colmap: colmap || null }),
    show: (path, done) => show(editor, path, done, place),
  });
}

async function show(
  editor: Editor,
  path: string,
  { found, photographs, isRough, isScaleGuessed, start, diagnostics }: HostOutput<'photographs.import'>,
  place: Place,
): Promise<void> {
  await editor.fileWork(async () => {
    const id = makeAssetId(editor.document.getState().project, path.slice(0, path.lastIndexOf('/')), editor.random);
    const asset = { path, kind: 'capture' } as const;
    const node = placeAsset(editor, { id, asset, start }, place);
    if (node !== null) selectOnly(editor.selection, [node]);
  });
  await refreshAssetFiles(editor);
  const count =
    found === photographs ? `${found} photographs.` : `${found} of ${photographs} photographs: COLMAP found no cameras for the others.`;
  const text = `Added ${nameOf(path)}.`;
  const detail = `${count}${isRough ? ' Its mesh is rough, because COLMAP needs CUDA for depth.' : ''}`;
  if (editor.ui.getState().dialog === null) {
    // It shows the warnings and where the scale is from, too.
    showCaptureReport(editor, path, `${text} ${detail}`);
    return;
  }
  for (const warning of diagnostics as readonly Diagnostic[]) toastDiagnostic(editor.ui, warning);
  addToast(editor.ui, { tone: 'success', text, detail: isScaleGuessed ? `${detail} Set its true size in the inspector.` : detail });
}
