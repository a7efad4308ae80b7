import type { RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import { findChromium } from '../../services/chromium.ts';
import { refusal } from '../../services/file-errors.ts';
import type { MeasuredShot } from '../../services/rephotograph/rephotograph-report.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import { withPage } from '../render/with-page.ts';
import type * as RephotographPage from './rephotograph.page.ts';

export interface RephotographJob {
  /** Folder with the sources of Scrim. */
  readonly root: string;
  /** Real path of the folder of the capture. */
  readonly folder: string;
  readonly methods: readonly RephotographMethod[];
  /** Number of photographs per pixel (lumigraph). */
  readonly blended: number;
  readonly onView: (index: number, shots: readonly MeasuredShot[]) => Promise<void>;
  readonly say: (text: string) => void;
  readonly interrupted: AbortSignal;
}

const PAGE_ENTRY = 'app/cli/rephotograph/rephotograph.page.ts';

/**
 * Renders each photograph of a capture from all others, in a headless browser.
 *
 * @throws SCR071 without a browser, SCR032 if a file of the capture is invalid
 */
export async function rephotographViews(job: RephotographJob): Promise<void> {
  const found = await findChromium();
  if (found === null) throw refusal(NO_BROWSER.code, NO_BROWSER.message, NO_BROWSER.fix);
  const page = { root: job.root, entry: PAGE_ENTRY, folders: { capture: job.folder } };
  await withPage<typeof RephotographPage, void>(found, page, async (call) => {
    job.say('Loading the photographs…');
    const count = await call('open', 'capture/', job.methods, job.blended).catch((error: unknown) => {
      throw asRefusal(error, job.folder);
    });
    for (let index = 0; index < count; index++) {
      job.interrupted.throwIfAborted();
      job.say(`Rendering photographs (${index + 1} of ${count})…`);
      const shots = await call('rephotographView', index);
      await job.onView(
        index,
        shots.map((shot) => ({ ...shot, picture: bytesOf(shot.picture), error: bytesOf(shot.error) })),
      );
    }
  });
}

/** The page’s errors have the name of their class in the text. */
function asRefusal(error: unknown, folder: string): unknown {
  const message = /CaptureError: (.*)/.exec(error instanceof Error ? error.message : '')?.[1];
  return message === undefined ? error : refusal('SCR032', `${folder} cannot be shown: ${message}.`);
}

function bytesOf(dataUrl: string): Uint8Array {
  return Buffer.from(dataUrl.slice(dataUrl.indexOf(',') + 1), 'base64');
}
