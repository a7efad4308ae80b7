import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { makeAssetId } from '../../../export/graph/document-names.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { nameOf, refreshAssetFiles } from '../files/edit-assets.ts';
import { showRefusal } from '../files/files.ts';
import { CANCELED, isCancelled, playDrawnWork, readyProgram, showProgress } from '../preview/drawn-work.ts';
import type { AcquisitionPlan } from './acquisition-form.ts';

/**
 * Takes photographs of a layer in a separate page, which the host packs into a capture, and adds it to the assets of the project.
 *
 * @param layer A layer with depth that the program keeps for viewing.
 * @returns The id of the asset; null if the user canceled, or it failed.
 */
export async function photographScene(editor: Editor, { name, camera, poses }: AcquisitionPlan, layer: string): Promise<string | null> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return null;
  const ready = readyProgram(editor, 'The project has problems. Fix them, then take photographs.');
  if (ready === null) return null;
  const { handle, assetBaseUrl } = open;
  const cancelOnHost = () => editor.host.call('capture.cancel', { handle });
  return playDrawnWork(editor, {
    handle,
    text: 'Loading the scene…',
    cancelOnHost,
    reportCanceled: () => addToast(editor.ui, { tone: 'info', text: 'Photographs canceled.', detail: 'Nothing was added.' }),
    run: async (page) => {
      editor.ui.setState({ dialog: null });
      await editor.host.call('capture.begin', { handle, name, camera, poses: poses.map((pose) => [...pose]) });
      page.isOnHost = true;
      if ((await page.ask({ kind: 'photographs-begin', request: { ...ready, assetBaseUrl, layer } })) === null) return CANCELED;
      for (const [index, worldFromCamera] of poses.entries()) {
        showProgress(editor, `Photograph ${index + 1} of ${poses.length}`);
        const answer = await page.ask({ kind: 'photograph', camera, worldFromCamera });
        if (answer?.kind !== 'photographed' || answer.photograph === null) return CANCELED;
        const { color, depth } = answer.photograph;
        await editor.host.call('capture.add', {
          handle,
          index,
          colorSize: { widthPx: color.widthPx, heightPx: color.heightPx },
          rgba: color.pixels,
          depthSize: { widthPx: depth.widthPx, heightPx: depth.heightPx },
          meters: new Uint8Array(depth.meters.buffer),
        });
      }
      if (isCancelled(editor)) return CANCELED;
      showProgress(editor, 'Packing photographs…');
      // The host deletes the photographs at the end, and when it fails.
      page.isOnHost = false;
      void page.canceled.then(cancelOnHost).catch((error: unknown) => showRefusal(editor, error));
      const { path, diagnostics } = await editor.host.call('capture.finish', { handle });
      if (path === null || editor.document.getState().open?.handle !== handle) return CANCELED;
      return addCapture(editor, path, diagnostics as readonly Diagnostic[]);
    },
  });
}

async function addCapture(editor: Editor, path: string, warnings: readonly Diagnostic[]): Promise<string | null> {
  const added = await editor.fileWork(async () => {
    const { project } = editor.document.getState();
    const id = makeAssetId(project, path.slice(0, path.lastIndexOf('/')), editor.random);
    return apply(editor, `Add ${nameOf(path)}`, putAsset(project, { id, asset: { path, kind: 'capture' } })) ? id : null;
  });
  await refreshAssetFiles(editor);
  editor.ui.setState({ bottom: 'assets' });
  for (const warning of warnings) toastDiagnostic(editor.ui, warning);
  addToast(editor.ui, { tone: 'success', text: `Added ${nameOf(path)} to the assets.`, detail: 'Its button + adds a node that shows it.' });
  return added;
}
