import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import sharp from 'sharp';
import { foldersOf, PAGE_FOLDERS } from '../../app/cli/render/render-frames.ts';
import { findRenderSession } from '../../app/cli/render/render-session.ts';
import { withPage } from '../../app/cli/render/with-page.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { compileProject, LIBRARY } from '../../app/services/compile-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { hasPaletteImage, PALETTE_COLUMNS } from '../../renderer/state/graph/palette-images.ts';
import { updatesGoldens } from '../support/this-test.ts';
import type * as PalettePage from './palette-images.page.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const SHEET = join(ROOT, 'renderer/canvas/palette-images.webp');
const LIST = join(ROOT, 'renderer/state/graph/palette-image-types.ts');

/** Strokes and outlines have widths in pixels, so the render is larger than the images. */
const RENDER = { widthPx: 480, heightPx: 320 } as const;
const TILE = { width: 96, height: 64 } as const;
/** A program with all filters would need more targets than some drivers give. */
const AT_ONCE = 24;
const QUALITY = 84;
/** Mean difference of a tile in steps of 255 that compression may make. */
const TOLERANCE = 8;

const filters = [...LIBRARY.types()].sort().flatMap((type) => {
  const definition = LIBRARY.definition(type);
  return definition && hasPaletteImage(definition) ? [definition] : [];
});

/** `UPDATE_GOLDENS=1` writes the sheet that the palette shows, and the list of its types. */
test('the images of the palette are what its filters make of the studio', async () => {
  const tiles = await drawTiles();
  expect([...tiles.keys()]).toEqual(filters.map(({ type }) => type));
  const rows = Math.ceil(tiles.size / PALETTE_COLUMNS);
  if (updatesGoldens()) {
    const placed = [...tiles.values()].map((input, i) => ({ input, ...placeOf(i) }));
    const create = { width: PALETTE_COLUMNS * TILE.width, height: rows * TILE.height, channels: 3, background: '#14161a' } as const;
    await writeFile(SHEET, await sharp({ create }).composite(placed).webp({ quality: QUALITY, smartSubsample: true }).toBuffer());
    const types = [...tiles.keys()].map((type) => `  '${type}',\n`).join('');
    await writeFile(
      LIST,
      `/** Types in the order of \`palette-images.webp\`. Written by \`tests/slow/palette-images.test.ts\`. */\nexport const PALETTE_IMAGE_TYPES: readonly string[] = [\n${types}];\n`,
    );
  }
  const sheet = await readFile(SHEET);
  const outdated: string[] = [];
  for (const [i, [type, tile]] of [...tiles].entries()) {
    const now = await sharp(tile).removeAlpha().raw().toBuffer();
    const kept = await sharp(sheet)
      .extract({ ...placeOf(i), ...TILE })
      .removeAlpha()
      .raw()
      .toBuffer();
    const sum = now.reduce((total, value, at) => total + Math.abs(value - (kept[at] ?? 0)), 0);
    if (sum / now.length > TOLERANCE) outdated.push(type);
  }
  expect(outdated).toEqual([]);
});

function placeOf(index: number) {
  return { left: (index % PALETTE_COLUMNS) * TILE.width, top: Math.floor(index / PALETTE_COLUMNS) * TILE.height };
}

async function drawTiles(): Promise<ReadonlyMap<string, Buffer>> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-palette-'));
  const tiles = new Map<string, Buffer>();
  try {
    for (let at = 0; at < filters.length; at += AT_ONCE) {
      const some = filters.slice(at, at + AT_ONCE);
      for (const [i, layer] of (await drawLayers(folder, some)).entries()) {
        const type = some[i]?.type;
        if (layer && type !== undefined) tiles.set(type, await tileOf(layer));
      }
    }
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
  return tiles;
}

/** Draws the first frame of the studio session with each filter. */
async function drawLayers(folder: string, some: readonly NodeDefinition[]) {
  const id = (i: number) => `filter-a${i}`;
  const nodes = Object.fromEntries(some.map(({ type, version }, i) => [id(i), { type, version, params: {} }]));
  const wires = some.map(({ inputs }, i) => `video-a.layer -> ${id(i)}.${Object.keys(inputs).find((port) => inputs[port]?.required)}`);
  const bare = (type: string) => ({ type, version: LIBRARY.definition(type)?.version, params: {} });
  const main = {
    nodes: { 'video-a': bare('source/camera-video'), 'screen-a': bare('output/screen'), ...nodes },
    wires: ['video-a.layer -> screen-a.layer', ...wires],
  };
  const project = JSON.stringify({ format: 'scrim-project', version: 1, title: 'Palette', graphs: { main } });
  const taps = some.map((_, i) => `${id(i)}.layer`);
  const { program, diagnostics } = await compileProject(folder, { project, layout: null, sources: {} }, () => ({ taps }));
  const found = await findChromium({ pinnedOnly: true });
  const session = await findRenderSession(null, folder, installationAt(ROOT, '0.0.0'), RENDER);
  if (program === null || found === null || session.output === null) throw new Error(JSON.stringify(diagnostics, null, 2));
  const job = { program, ...RENDER, ...PAGE_FOLDERS, session: session.output.session, subject: { kind: 'screen' } as const };
  const folders = foldersOf({ root: ROOT, projectRoot: folder, sessionFolders: session.output.sessionFolders });
  const page = { root: ROOT, entry: 'tests/slow/palette-images.page.ts', folders };
  return withPage<Pick<typeof PalettePage, 'open' | 'layers'>, Awaited<ReturnType<typeof PalettePage.layers>>>(
    found,
    page,
    async (call) => {
      await call('open', job);
      return call('layers', taps);
    },
  );
}

function tileOf({ widthPx, heightPx, base64 }: { readonly widthPx: number; readonly heightPx: number; readonly base64: string }) {
  return sharp(Buffer.from(base64, 'base64'), { raw: { width: widthPx, height: heightPx, channels: 4, premultiplied: true } })
    .flatten({ background: '#14161a' })
    .resize(TILE.width, TILE.height, { fit: 'cover' })
    .png()
    .toBuffer();
}
