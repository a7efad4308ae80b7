import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import { CELL } from './draw-example.ts';

export interface SheetCell {
  readonly title: string;
  readonly png: Uint8Array;
}

const COLUMNS = 4;
const GAP_PX = 10;
const CAPTION_PX = 26;
/** JPEG quality that keeps a sheet of 30 cells below 400 kB. */
const QUALITY = 72;

/** Combines images with their titles into one JPEG. */
export async function makeSheet(cells: readonly SheetCell[]): Promise<Uint8Array> {
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found to lay the pictures out in. Install Chromium, or name it in SCRIM_CHROMIUM.');
  const browser = await startBrowser(found);
  try {
    const width = COLUMNS * (CELL.widthPx + GAP_PX) + GAP_PX;
    const height = Math.ceil(cells.length / COLUMNS) * (CELL.heightPx + CAPTION_PX + GAP_PX) + GAP_PX;
    const page = await browser.newPage({ viewport: { width, height } });
    await page.setContent(htmlOf(cells));
    await page.evaluate(async () => {
      await Promise.all([...document.images].map((image) => image.decode()));
    });
    return await page.screenshot({ type: 'jpeg', quality: QUALITY });
  } finally {
    await browser.close();
  }
}

function htmlOf(cells: readonly SheetCell[]): string {
  const figures = cells.map(
    ({ title, png }) =>
      `<figure><img src="data:image/png;base64,${Buffer.from(png).toString('base64')}" alt=""><figcaption>${escaped(title)}</figcaption></figure>`,
  );
  return `<!doctype html><style>
    body { margin: ${GAP_PX}px; background: #14161a; color: #e8e6e1; font: 14px/${CAPTION_PX}px sans-serif;
      display: grid; grid-template-columns: repeat(${COLUMNS}, ${CELL.widthPx}px); gap: ${GAP_PX}px }
    figure { margin: 0 }
    img { display: block; width: ${CELL.widthPx}px; height: ${CELL.heightPx}px; background: #000 }
    figcaption { height: ${CAPTION_PX}px; overflow: hidden; white-space: nowrap; text-overflow: ellipsis }
  </style>${figures.join('')}`;
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}
