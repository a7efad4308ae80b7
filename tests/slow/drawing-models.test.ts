import { copyFile, mkdir, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp from 'sharp';
import { measureModel } from '../../tools/contact-sheets/measure-model.ts';
import { CELL_PX, LIGHTS, sheetProject, sheetSession } from '../../tools/contact-sheets/sheet-project.ts';
import { decodeImage, encodeImage, type RgbaImage } from '../support/image.ts';
import { LIBRARY } from '../support/library.ts';
import { writeProject } from '../support/project-kit.ts';
import { succeed } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

const MODELS = ['Fox.glb', 'LeePerrySmith.glb'] as const;
/**
 * Drawings, and the least correlation of their tones with those of a model, where strokes are averaged. The hatched fox is a few strokes
 * wide: in light from the side it reaches 0.59.
 */
const DRAWINGS = [
  ['charcoal-drawing', 0.7],
  ['pencil-drawing', 0.8],
  ['hatched-drawing', 0.55],
  ['watercolor', 0.8],
  ['oil-painting', 0.8],
  ['comic-drawing', 0.8],
] as const;
/** The blur that averages strokes: standard deviation in pixels. */
const AVERAGED_PX = 7;
const WALL = 190;

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
    await writeProject(session, { 'session.json': JSON.stringify(file), 'wall.png': wall });
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test.each(DRAWINGS)('%s keeps the tones of each model in each light', async (name, least) => {
    const folder = join(base, name);
    await mkdir(join(folder, 'assets'), { recursive: true });
    const measured = await Promise.all(MODELS.map((model) => measureModel(join(models, model))));
    for (const [i, { file }] of measured.entries()) await copyFile(file, join(folder, 'assets', `${i}.glb`));
    const style = { name, type: `filter/${name}` };
    const project = sheetProject(measured, style, (type) => LIBRARY.definition(type)?.version ?? 1);
    await writeProject(folder, { 'project.scrim.json': JSON.stringify(project) });
    const shots = [];
    for (const layer of [`over${LIGHTS.length - 1}-s.layer`, 'style-s.layer']) {
      const out = join(folder, `${layer}.png`);
      await succeed('render', folder, '--session', session, '--size', size, '--layer', layer, '--out', out);
      shots.push(await readFile(out));
    }
    const [plain, drawn] = shots as [Buffer, Buffer];
    const cover = decodeImage(plain);
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

/** Luma, averaged over strokes. */
async function averaged(png: Buffer): Promise<Uint8Array> {
  return sharp(png).flatten({ background: '#fff' }).toColorspace('b-w').blur(AVERAGED_PX).raw().toBuffer();
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
