import type { Page } from 'playwright-core';
import { POSTER_SIZE, type PosterPicture } from '../../../export/bundle/poster.ts';
import type { Program } from '../../../export/program/program.ts';
import { HostError } from '../../contract/host-error.ts';
import { findChromium } from '../../services/chromium.ts';
import { encodeLayer } from '../../services/encode-png.ts';
import type { Installation } from '../../services/installation.ts';
import { startBrowser } from '../../services/start-browser.ts';
import { renderFrames } from './render-frames.ts';
import { findRenderSession } from './render-session.ts';

export interface PosterJob {
  readonly program: Program;
  /** The project's real folder. */
  readonly projectRoot: string;
  readonly installation: Installation;
}

/**
 * What a page shows, in the room that `scrim render` plays by default: its first frame, as JPEG. Null where there is no browser to
 * draw with, or the project cannot be drawn in it: a page does without. Throws a shader's SCR042: no page draws what does not compile.
 */
export async function drawPoster({ program, projectRoot, installation }: PosterJob): Promise<PosterPicture | null> {
  const found = await findChromium();
  const session = await findRenderSession(null, projectRoot, installation, POSTER_SIZE);
  if (found === null || session.output === null) return null;
  let png: Uint8Array | null = null;
  const said = await renderFrames({
    ...session.output,
    first: 0,
    last: 0,
    root: installation.root,
    projectRoot,
    job: { program, session: session.output.session, ...POSTER_SIZE, subject: { kind: 'screen' } },
    sourceOf: () => undefined,
    onPicture: async (_index, { widthPx, heightPx }, pixels) => {
      png = encodeLayer({ widthPx, heightPx, pixels });
    },
    say: () => {},
  });
  const broken = said.find(({ code, severity }) => code === 'SCR042' && severity === 'error');
  if (broken) throw new HostError(broken);
  if (png === null) return null;
  const browser = await startBrowser(found);
  try {
    return { type: 'jpg', bytes: await toJpeg(await browser.newPage({ viewport: VIEWPORT }), png), ...POSTER_SIZE, drawn: true };
  } finally {
    await browser.close();
  }
}

const VIEWPORT = { width: POSTER_SIZE.widthPx, height: POSTER_SIZE.heightPx };

/** An eighth of what the same picture takes as PNG, and nobody sees it. */
const QUALITY = 82;

/** The browser is the only encoder at hand. Where the picture is transparent, the page's own ground shows. */
async function toJpeg(page: Page, png: Uint8Array): Promise<Uint8Array> {
  const source = `data:image/png;base64,${Buffer.from(png).toString('base64')}`;
  await page.evaluate(async (src) => {
    const image = new Image();
    image.src = src;
    await image.decode();
    document.body.style.cssText = 'margin: 0; background: #14161a';
    document.body.replaceChildren(image);
  }, source);
  return page.screenshot({ type: 'jpeg', quality: QUALITY });
}
