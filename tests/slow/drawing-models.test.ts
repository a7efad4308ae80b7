import { copyFile, mkdir, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { measureModel } from '../../tools/contact-sheets/measure-model.ts';
import { AWAY_M, CELL_M, CELL_PX, LIGHTS, type SheetModel, sheetProject, sheetSession } from '../../tools/contact-sheets/sheet-project.ts';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, type RgbaImage } from '../support/image.ts';
import { LIBRARY } from '../support/library.ts';
import { writeProject } from '../support/project-kit.ts';
import { renderLayers } from '../support/render-layers.ts';
import { describeWithData } from '../support/shared-data.ts';

const MODELS = ['Fox.glb', 'LeePerrySmith.glb'] as const;
/** Drawings, and the least correlation of their tones with those of a model, where strokes are averaged. */
const DRAWINGS = [
  ['charcoal-drawing', 0.8],
  ['pencil-drawing', 0.9],
  ['hatched-drawing', 0.7],
  ['watercolor', 0.85],
  ['oil-painting', 0.95],
  ['comic-drawing', 0.9],
  ['stipple', 0.9],
  ['engraving', 0.9],
  ['pointillism', 0.9],
] as const;
/** The blur that averages strokes: standard deviation in pixels. */
const AVERAGED_PX = 7;
const WALL = 190;
/**
 * Moves of the picture in pixels. Strokes keep their place on screen, so each move draws a model with others. A model is a few strokes wide:
 * with one move each, the correlation of the hatched head in light from behind was between 0.49 and 0.75, by chance.
 */
const MOVES = [
  [0, 0],
  [16, 5],
  [-13, 11],
  [7, -15],
] as const;

const SHEET = `over${LIGHTS.length - 1}-s.layer`;
const layerOf = (drawing: string) => `${drawing}-s.layer`;

describeWithData('drawings of a fox and a head', 'models', (models) => {
  const chromium = useBrowser();
  let base = '';
  let layers: ReadonlyMap<string, readonly RgbaImage[]>;
  /** The models without style, which are the same for each style: where they are, and their tones. */
  let plain: RgbaImage;
  let asked: Uint8Array;

  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-drawn-'));
    const { session: file, widthPx, heightPx } = sheetSession(MODELS.length);
    const wall = encodeImage({
      width: widthPx,
      height: heightPx,
      data: new Uint8Array(widthPx * heightPx * 4).fill(WALL).map((v, i) => (i % 4 === 3 ? 255 : v)),
    });
    const frames = MOVES.map(([x, y], i) => ({
      timeS: i / 10,
      color: 'wall.png',
      // The picture moves against the camera; its y axis points down.
      worldFromCamera: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, (-x / CELL_PX) * CELL_M, (y / CELL_PX) * CELL_M, AWAY_M, 1],
    }));
    const [project, session] = [join(base, 'project'), join(base, 'session')];
    await writeProject(session, { 'session.json': JSON.stringify({ ...file, frames }), 'wall.png': wall });
    const measured = await Promise.all(MODELS.map((model) => measureModel(join(models, model))));
    await writeProject(project, { 'project.scrim.json': allDrawings(measured) });
    await mkdir(join(project, 'assets'), { recursive: true });
    for (const [i, model] of measured.entries()) await copyFile(model.file, join(project, 'assets', `${i}.glb`));
    layers = await renderLayers(chromium.browser, {
      ...{ project, session, widthPx, heightPx, frames: MOVES.length },
      layers: [SHEET, ...DRAWINGS.map(([drawing]) => layerOf(drawing))],
    });
    plain = shotsOf(SHEET)[0] as RgbaImage;
    asked = await averaged(shotsOf(SHEET));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  const shotsOf = (layer: string): readonly RgbaImage[] => layers.get(layer) ?? [];

  test.each(DRAWINGS)('%s keeps the tones of each model in each light', async (name, least) => {
    const got = await averaged(shotsOf(layerOf(name)));
    const low: string[] = [];
    LIGHTS.forEach((light, row) => {
      MODELS.forEach((model, column) => {
        const at = pixelsOf(plain, column, row);
        expect(at.length).toBeGreaterThan(3000);
        const kept = correlation(
          at.map((i) => asked[i] ?? 0),
          at.map((i) => got[i] ?? 0),
        );
        if (!(kept >= least)) low.push(`${model}, ${light.name}: ${kept.toFixed(2)}`);
      });
    });
    expect(low).toEqual([]);
  });
});

/** A sheet with all drawings over the same models. */
function allDrawings(measured: readonly SheetModel[]): string {
  const version = (type: string): number => LIBRARY.definition(type)?.version ?? 1;
  const [[first]] = DRAWINGS;
  const sheet = sheetProject(measured, { name: first, type: `filter/${first}` }, version) as SheetProject;
  const { nodes, wires } = sheet.graphs.main;
  for (const [drawing] of DRAWINGS) {
    nodes[`${drawing}-s`] = { type: `filter/${drawing}`, version: version(`filter/${drawing}`), params: {} };
    wires.push(`${SHEET} -> ${drawing}-s.inputImage`);
  }
  return JSON.stringify(sheet);
}

interface SheetProject {
  readonly graphs: { readonly main: { readonly nodes: Record<string, object>; readonly wires: string[] } };
}

/** Luma, averaged over strokes and over all moves. */
async function averaged(shots: readonly RgbaImage[]): Promise<Uint8Array> {
  let sums = new Float64Array();
  let size = { width: 0, height: 0 };
  for (const [i, { width, height, data: pixels }] of shots.entries()) {
    const raw = { width, height, channels: 4 } as const;
    const { data, info } = await sharp(pixels, { raw })
      .flatten({ background: '#fff' })
      .toColorspace('b-w')
      .raw()
      .toBuffer({ resolveWithObject: true });
    size = info;
    if (sums.length === 0) sums = new Float64Array(data.length);
    const [x, y] = MOVES[i] ?? [0, 0];
    const inside = (at: number, end: number): number => Math.min(Math.max(at, 0), end - 1);
    for (let at = 0; at < data.length; at++) {
      const column = inside((at % info.width) + x, info.width);
      const row = inside(Math.floor(at / info.width) + y, info.height);
      sums[at] = (sums[at] ?? 0) + (data[row * info.width + column] ?? 0) / shots.length;
    }
  }
  return sharp(Uint8Array.from(sums, Math.round), { raw: { ...size, channels: 1 } })
    .blur(AVERAGED_PX)
    .toColorspace('b-w')
    .raw()
    .toBuffer();
}

/** Pixels of the model in a cell: those that are not the wall. */
function pixelsOf({ width, data }: RgbaImage, column: number, row: number): number[] {
  const at: number[] = [];
  for (let y = row * CELL_PX; y < (row + 1) * CELL_PX; y++) {
    for (let x = column * CELL_PX; x < (column + 1) * CELL_PX; x++) {
      const i = y * width + x;
      if ([0, 1, 2].some((c) => Math.abs((data[i * 4 + c] ?? 0) - WALL) > 2)) at.push(i);
    }
  }
  return at;
}

function correlation(a: readonly number[], b: readonly number[]): number {
  const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [ma, mb] = [mean(a), mean(b)];
  let [ab, aa, bb] = [0, 0, 0];
  a.forEach((value, i) => {
    const [da, db] = [value - ma, (b[i] ?? 0) - mb];
    ab += da * db;
    aa += da * da;
    bb += db * db;
  });
  return ab / Math.sqrt(aa * bb);
}
