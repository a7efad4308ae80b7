import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { findChromium } from '../../services/chromium.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import { firstPlayed, foldersOf, openingDiagnostics, PAGE_FOLDERS, type RenderOptions } from '../render/render-frames.ts';
import { type CallPage, withPage } from '../render/with-page.ts';
import type * as ScorePage from './score.page.ts';
import type { ScoredLayer } from './score.page.ts';

export interface ScoreOptions extends Omit<RenderOptions, 'last' | 'onImage'> {
  /** Number of the last frame, included; null for that of the session. */
  readonly last: number | null;
  readonly layers: readonly ScoredLayer[];
  readonly reference: string | null;
  readonly interrupted: AbortSignal;
}

export interface ScoredFrames {
  readonly frames: readonly ScorePage.FrameScore[];
  readonly diagnostics: readonly Diagnostic[];
}

const PAGE_ENTRY = 'app/cli/score/score.page.ts';

/** Plays frames of a recorded session in a headless browser, as `renderFrames` does, and measures each. Frames without depth are left out. */
export async function scoreFrames(options: ScoreOptions): Promise<ScoredFrames> {
  const found = await findChromium();
  if (found === null) return { frames: [], diagnostics: [NO_BROWSER] };
  const page = { root: options.root, entry: PAGE_ENTRY, folders: foldersOf(options) };
  return withPage<typeof ScorePage, ScoredFrames>(found, page, (call) => play(call, options));
}

async function play(call: CallPage<typeof ScorePage>, options: ScoreOptions): Promise<ScoredFrames> {
  const { job, layers, reference, interrupted, first, say } = options;
  const opened = await call('open', { ...job, ...PAGE_FOLDERS, layers, reference });
  const last = options.last ?? (opened.frameCount ?? 1) - 1;
  const early = [...openingDiagnostics({ ...options, last: Math.max(first, last) }, opened), ...(await call('diagnostics'))];
  if (hasErrors(early)) return { frames: [], diagnostics: early };
  const frames: ScorePage.FrameScore[] = [];
  for (let index = firstPlayed(options); index <= last; index++) {
    interrupted.throwIfAborted();
    if (index < first) await call('skip', index);
    else {
      const frame = await call('score', index);
      if (frame) frames.push(frame);
      say(`Frame ${index} of ${first}..${last}`);
    }
    const now = await call('diagnostics');
    if (hasErrors(now)) return { frames, diagnostics: [...early, ...now] };
  }
  return { frames, diagnostics: [...early, ...(await call('diagnostics'))] };
}
