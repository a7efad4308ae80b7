import { copyFile, mkdir, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { measureModel } from '../../tools/contact-sheets/measure-model.ts';
import { AWAY_M, CELL_M, CELL_PX, LIGHTS, sheetProject, sheetSession } from '../../tools/contact-sheets/sheet-project.ts';
import { decodeImage, encodeImage, type RgbaImage } from '../support/image.ts';
import { LIBRARY } from '../support/library.ts';
import { writeProject } from '../support/project-kit.ts';
import { succeed } from '../support/scrim.ts';
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

let base = '';

describeWithData('drawings of a fox and a head', 'models', (models) => {
  let session = '';
  let size = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-drawn-'));
    const { session: file, widthPx, heightPx } = sheetSession(MODELS.length);
    size = `${widthPx}x${heightPx}`;
    session = join(base, 'session');
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
    await writeProject(session, { 'session.json': JSON.stringify({ ...file, frames }), 'wall.png': wall });
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  /** The models without style, which is the same for each style. */
  let plain: readonly Buffer[] | null = null;

  async function shotsOf(folder: string, layer: string): Promise<readonly Buffer[]> {
    const out = join(folder, layer);
    const frames = `0..${MOVES.length - 1}`;
    await succeed('render', folder, '--session', session, '--size', size, '--layer', layer, '--frames', frames, '--out', out);
    return Promise.all(MOVES.map((_, i) => readFile(join(out, `00000${i}.png`))));
  }

  test.each(DRAWINGS)('%s keeps the tones of each model in each light', async (name, least) => {
    const folder = join(base, name);
    await mkdir(join(folder, 'assets'), { recursive: true });
    const measured = await Promise.all(MODELS.map((model) => measureModel(join(models, model))));
    for (const [i, { file }] of measured.entries()) await copyFile(file, join(folder, 'assets', `${i}.glb`));
    const style = { name, type: `filter/${name}` };
    const project = sheetProject(measured, style, (type) => LIBRARY.definition(type)?.version ?? 1);
    await writeProject(folder, { 'project.scrim.json': JSON.stringify(project) });
    plain ??= await shotsOf(folder, `over${LIGHTS.length - 1}-s.layer`);
    const drawn = await shotsOf(folder, 'style-s.layer');
    const [still] = plain;
    if (!still) throw new Error('There is a frame.');
    const cover = decodeImage(still);
    const [asked, got] = await Promise.all([averaged(plain), averaged(drawn)]);
    const low: string[] = [];
    LIGHTS.forEach((light, row) => {
      MODELS.forEach((model, column) => {
        const at = pixelsOf(cover, column, row);
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

/** Luma, averaged over strokes and over all moves. */
async function averaged(shots: readonly Buffer[]): Promise<Uint8Array> {
  const sums: number[] = [];
  let size = { width: 0, height: 0 };
  for (const [i, png] of shots.entries()) {
    const { data, info } = await sharp(png).flatten({ background: '#fff' }).toColorspace('b-w').raw().toBuffer({ resolveWithObject: true });
    size = info;
    const [x, y] = MOVES[i] ?? [0, 0];
    const inside = (at: number, end: number): number => Math.min(Math.max(at, 0), end - 1);
    for (let at = 0; at < data.length; at++) {
      const [column, row] = [inside((at % info.width) + x, info.width), inside(Math.floor(at / info.width) + y, info.height)];
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
