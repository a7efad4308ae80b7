import type { RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import type { DrawnRephotograph } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast, type RephotographMeans } from '../editor/ui.ts';
import { showRefusal } from '../files/files.ts';
import { CANCELED, isCancelled, playDrawnWork, showProgress } from '../preview/drawn-work.ts';

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
  const { handle, assetBaseUrl } = open;
  const done = await playDrawnWork(editor, {
    handle,
    text: 'Loading the photographs…',
    cancelOnHost: () => editor.host.call('rephotograph.cancel', { handle }),
    reportCanceled: () => addToast(editor.ui, { tone: 'info', text: 'Rephotography canceled.', detail: 'No report was written.' }),
    run: async (page) => {
      editor.ui.setState({ dialog: null });
      const { methods, views } = await editor.host.call('rephotograph.begin', { handle, path, method, blended });
      page.isOnHost = true;
      const folder = path.slice(0, path.lastIndexOf('/') + 1);
      if ((await page.ask({ kind: 'rephotograph-begin', request: { assetBaseUrl, folder, methods, blended } })) === null) return CANCELED;
      for (let index = 0; index < views; index++) {
        showProgress(editor, `Photograph ${index + 1} of ${views}`);
        for (const each of methods) {
          const answer = await page.ask({ kind: 'rephotograph', index, method: each });
          if (answer?.kind !== 'rephotographed' || answer.shot === null) return CANCELED;
          await editor.host.call('rephotograph.add', { handle, index, method: each, ...message(answer.shot) });
        }
      }
      if (isCancelled(editor)) return CANCELED;
      const { means } = await editor.host.call('rephotograph.finish', { handle });
      page.isOnHost = false;
      if (editor.document.getState().open?.handle !== handle) return CANCELED;
      return { path, views, means };
    },
  });
  if (done !== null) showMeans(editor, done);
  return done !== null;
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

/** A photograph as the host takes it. Messages have null for figures that are no numbers. */
function message({ shown, error, widthPx, heightPx, psnrDb, ssim, chromaError, covered }: DrawnRephotograph) {
  const known = (figure: number): number | null => (Number.isFinite(figure) ? figure : null);
  return {
    size: { widthPx, heightPx },
    psnrDb: known(psnrDb),
    ssim: known(ssim),
    chromaError: known(chromaError),
    covered: known(covered),
    picture: shown,
    error: new Uint8Array(error.buffer),
  };
}
