import { existsSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import sharp, { type OverlayOptions } from 'sharp';

/** The test that draws the pictures, and where it keeps them. */
const TEST = 'tests/slow/lamp-and-window.test.ts';
const PICTURES = 'tests/output/lamp-and-window';
const GAP_PX = 16;
const SIDE_PX = 320;

interface Tile {
  readonly picture: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Factor on the bytes, which makes what glasses add visible. */
  readonly gain?: number;
}

const square = (picture: string, gain = 1): Tile => ({ picture, widthPx: SIDE_PX, heightPx: SIDE_PX, gain });
const panorama = (picture: string): Tile => ({ picture, widthPx: 2 * SIDE_PX, heightPx: SIDE_PX });

/** Rows of tiles for each figure. */
const FIGURES: Readonly<Record<string, readonly (readonly Tile[])[]>> = {
  'lamp-and-window': [[square('glasses-layer', 5), square('glasses-seen'), square('phone-seen')]],
  'panorama-retaken': [
    [panorama('taken-0'), square('moved-0-beside')],
    [panorama('taken-1'), square('moved-1-beside')],
  ],
  'self-shadow': [[square('glasses-beside'), square('phone-beside')]],
};

/** Composes the figures of the example “A lamp and a window” from the pictures that its test keeps, if they are there. */
export async function drawPageFigures(root: string): Promise<void> {
  if (!existsSync(join(root, PICTURES, 'moved-1-beside.png'))) {
    console.error(`The figures of the example are left out: run \`npm run test:one slow ${TEST}\` first, which draws their pictures.`);
    return;
  }
  for (const [name, rows] of Object.entries(FIGURES)) {
    const parts: OverlayOptions[] = [];
    for (const [y, row] of rows.entries()) {
      let left = 0;
      for (const { picture, widthPx, heightPx, gain = 1 } of row) {
        const input = await sharp(join(root, PICTURES, `${picture}.png`))
          .resize({ width: widthPx, height: heightPx })
          .linear(gain, 0)
          .png()
          .toBuffer();
        parts.push({ input, left, top: y * (SIDE_PX + GAP_PX) });
        left += widthPx + GAP_PX;
      }
    }
    const width = Math.max(...rows.map((row) => row.reduce((sum, { widthPx }) => sum + widthPx + GAP_PX, -GAP_PX)));
    const height = rows.length * (SIDE_PX + GAP_PX) - GAP_PX;
    const sheet = sharp({ create: { width, height, channels: 3, background: '#ffffff' } }).composite(parts);
    await writeFile(join(root, 'docs', 'images', `${name}.webp`), await sheet.webp({ quality: 85 }).toBuffer());
  }
}
