import type { Page } from 'playwright-core';
import { POSTER_SIZE, type PosterImage } from '../../../export/bundle/poster.ts';
import type { Program } from '../../../export/program/program.ts';
import type { PosterFraming } from '../../../nodes/kit/poster-framing.ts';
import { HostError } from '../../contract/host-error.ts';
import { findChromium } from '../../services/chromium.ts';
import { encodeLayer } from '../../services/encode-png.ts';
import type { Installation } from '../../services/installation.ts';
import { startBrowser } from '../../services/start-browser.ts';
import type { RenderSession } from './frame-source.page.ts';
import { renderFrames } from './render-frames.ts';
import type { SizePx } from './render-options.ts';
import { findRenderSession } from './render-session.ts';

export interface PosterJob {
  readonly program: Program;
  /** What the project lets the poster show; null: the objects. */
  readonly framing: PosterFraming | null;
  /** Real path of the project folder. */
  readonly projectRoot: string;
  readonly installation: Installation;
}

/**
 * Renders the poster of a page as JPEG: the first frame of the default session of `scrim render`, or of the room of the framing. Null if
 * there is no browser or the frame cannot be rendered; the page is then exported without one.
 *
 * @throws SCR042 if the driver rejects a shader
 */
export async function drawPoster({ program, framing, projectRoot, installation }: PosterJob): Promise<PosterImage | null> {
  const found = await findChromium();
  const room = framing?.room ? `room:${framing.room.name}` : null;
  const { output } = await findRenderSession(room, projectRoot, installation, null);
  if (found === null || output === null) return null;
  // A chosen part is rendered larger, so that it has enough pixels. Recordings keep their shape: a canvas of another one cuts them.
  const { widthPx, heightPx } = output.session.kind === 'recorded' ? covering(output.sizePx) : POSTER_SIZE;
  const scale = framing ? FRAMED_SCALE : 1;
  const size = { widthPx: widthPx * scale, heightPx: heightPx * scale };
  const session: RenderSession =
    output.session.kind === 'room' ? { ...output.session, sizePx: [size.widthPx, size.heightPx] } : output.session;
  let png: Uint8Array | null = null;
  const said = await renderFrames({
    ...output,
    first: 0,
    last: 0,
    root: installation.root,
    projectRoot,
    job: { program, session, ...size, subject: { kind: 'screen' }, poster: { framing, size: POSTER_SIZE } },
    sourceOf: () => undefined,
    onImage: async (_index, { widthPx, heightPx }, pixels) => {
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

/** Enlargement of framed posters before they are cropped. */
const FRAMED_SCALE = 2;
const VIEWPORT = { width: POSTER_SIZE.widthPx, height: POSTER_SIZE.heightPx };

/** The smallest size of a shape that covers the poster. */
function covering({ widthPx, heightPx }: SizePx): SizePx {
  const scale = Math.max(POSTER_SIZE.widthPx / widthPx, POSTER_SIZE.heightPx / heightPx);
  return { widthPx: Math.round(widthPx * scale), heightPx: Math.round(heightPx * scale) };
}

/** JPEG quality. The file is an eighth of the PNG, without visible loss. */
const QUALITY = 82;

/** Encodes with the browser, the only JPEG encoder at hand. The background is that of exported pages. */
async function toJpeg(page: Page, png: Uint8Array): Promise<Uint8Array> {
  const source = `data:image/png;base64,${Buffer.from(png).toString('base64')}`;
  await page.evaluate(async (src) => {
    const image = new Image();
    image.src = src;
    await image.decode();
    image.style.cssText = 'display: block; width: 100vw; height: 100vh; object-fit: cover';
    document.body.style.cssText = 'margin: 0; background: #14161a';
    document.body.replaceChildren(image);
  }, source);
  return page.screenshot({ type: 'jpeg', quality: QUALITY });
}
