import type { RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import type { Editor, FrameRenderQuestion } from '../editor/editor.ts';
import { addToast, type RephotographMeans } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';
import { cancellation, isCancelled, showFailure, showProgress, unwrap } from '../preview/drawn-work.ts';

export interface RephotographChoice {
  /** Path of `capture.json` in the project. */
  readonly path: string;
  /** Null: all that the capture can be drawn by. */
  readonly method: RephotographMethod | null;
  /** Number of photographs per pixel of the lumigraph. */
  readonly blended: number;
}

/**
 * Draws each photograph of a capture from all others in a separate page, of which the host writes a report, and shows the means. Returns
 * false if the user canceled, or it failed.
 */
export async function rephotographCapture(editor: Editor, { path, method, blended }: RephotographChoice): Promise<boolean> {
  const { open } = editor.document.getState();
  if (open === null || editor.ui.getState().exporting !== null) return false;
  const link = editor.renderPage.open?.();
  if (!link) return false;
  const { handle, assetBaseUrl } = open;
  editor.ui.setState({ exporting: { handle, text: 'Loading the photographs…', cancelled: false, frames: true }, dialog: null });
  const stopped = cancellation(editor);
  /** Sends a message to the page; resolves to null if the user cancels. */
  const ask = (message: FrameRenderQuestion) => Promise.race([link.ask(message), stopped.promise]);
  let begun = false;
  try {
    const { methods, views } = await editor.host.call('rephotograph.begin', { handle, path, method, blended });
    begun = true;
    const folder = path.slice(0, path.lastIndexOf('/') + 1);
    if (unwrap(await ask({ kind: 'rephotograph-begin', request: { assetBaseUrl, folder, methods, blended } })) === null)
      return reportCanceled(editor);
    for (let index = 0; index < views; index++) {
      showProgress(editor, `Photograph ${index + 1} of ${views}`);
      for (const each of methods) {
        const answer = unwrap(await ask({ kind: 'rephotograph', index, method: each }));
        if (answer?.kind !== 'rephotographed' || answer.shot === null) return reportCanceled(editor);
        const { shown, error, widthPx, heightPx, psnrDb, ssim, chromaError, covered } = answer.shot;
        await editor.host.call('rephotograph.add', {
          handle,
          index,
          method: each,
          size: { widthPx, heightPx },
          psnrDb: known(psnrDb),
          ssim: known(ssim),
          chromaError: known(chromaError),
          covered: known(covered),
          picture: shown,
          error: new Uint8Array(error.buffer),
        });
      }
    }
    if (isCancelled(editor)) return reportCanceled(editor);
    const { means } = await editor.host.call('rephotograph.finish', { handle });
    begun = false;
    if (editor.document.getState().open?.handle !== handle) return reportCanceled(editor);
    showMeans(editor, { path, views, means });
    return true;
  } catch (error) {
    // The host ends the work of a project that is closed.
    if (editor.document.getState().open?.handle !== handle) return reportCanceled(editor);
    showFailure(editor, error);
    return false;
  } finally {
    stopped.dispose();
    link.close();
    editor.ui.setState({ exporting: null });
    if (begun) await editor.host.call('rephotograph.cancel', { handle }).catch((error: unknown) => showRefusal(editor, error));
  }
}

/**
 * Shows the report of a capture in the browser.
 *
 * @param openTab Opens a tab, if the host has no browser.
 */
export async function showRephotographReport(editor: Editor, path: string, openTab: (url: string) => void): Promise<void> {
  const handle = editor.document.getState().open?.handle;
  if (handle === undefined) return;
  try {
    const { url, opened } = await editor.host.call('rephotograph.show', { handle, path });
    if (!opened) openTab(url);
  } catch (error) {
    showRefusal(editor, error);
  }
}

/** Another dialog stays open. */
function showMeans({ ui }: Editor, rephotographed: RephotographMeans): void {
  if (ui.getState().dialog === null) ui.setState({ dialog: { kind: 'rephotographed', rephotographed } });
  else addToast(ui, { tone: 'success', text: 'The capture is rephotographed.', detail: 'The report is in the folder reports.' });
}

/** Messages have null for figures that are no numbers. */
function known(figure: number): number | null {
  return Number.isFinite(figure) ? figure : null;
}

function reportCanceled({ ui }: Editor): false {
  addToast(ui, { tone: 'info', text: 'Rephotography canceled.', detail: 'No report was written.' });
  return false;
}
