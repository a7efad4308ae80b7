import { copyFile, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { scrim } from '../support/scrim.ts';

const EXAMPLE = resolve('nodes/source/capture/example/assets/glossy-ball.capture');
const VIEWS = 4;
let base = '';

/** The first views of the example, which are around the ball. */
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-rephotograph-'));
  const capture = JSON.parse(await readFile(join(EXAMPLE, 'capture.json'), 'utf8')) as { views: { file: string }[] };
  capture.views.splice(VIEWS);
  await mkdir(join(base, 'ball.capture/views'), { recursive: true });
  await writeFile(join(base, 'ball.capture/capture.json'), JSON.stringify(capture));
  for (const file of ['mesh.bin', ...capture.views.map((view) => view.file)]) {
    await copyFile(join(EXAMPLE, file), join(base, 'ball.capture', file));
  }
});
afterAll(() => rm(base, { recursive: true, force: true }));

interface Shot {
  readonly method: string;
  readonly psnrDb: number;
  readonly picture: string;
  readonly error: string;
}

test('each photograph is rendered from the others, and the report shows how far it differs', async () => {
  const out = join(base, 'report');
  const { status, out: said, err } = await scrim('rephotograph', join(base, 'ball.capture'), '--out', out);
  expect([status, err]).toEqual([0, '']);
  expect(said).toMatch(/Rendered 4 photographs.*\n {2}plain {9}\d+\.\d\d dB/);
  const report = JSON.parse(await readFile(join(out, 'report.json'), 'utf8')) as { views: { photo: string; shots: Shot[] }[] };
  expect(report.views).toHaveLength(VIEWS);
  for (const { photo, shots } of report.views) {
    expect(shots.map(({ method }) => method)).toEqual(['plain', 'nearest', 'lumigraph']);
    expect(await readFile(join(out, photo))).toEqual(await readFile(join(base, 'ball.capture', photo)));
    for (const { psnrDb, picture, error } of shots) {
      // The photograph itself would be infinite, or above 45 dB through JPEG.
      expect(psnrDb).toBeGreaterThan(15);
      expect(psnrDb).toBeLessThan(40);
      for (const file of [picture, error]) {
        expect(decode(await readFile(join(out, file)))).toMatchObject({ width: 320, height: 240 });
      }
    }
  }
  const page = await readFile(join(out, 'index.html'), 'utf8');
  const sources = [...page.matchAll(/<img src="([^"]+)"/g)].map(([, source]) => source);
  expect(sources.sort()).toEqual((await readdir(join(out, 'views'))).map((name) => `views/${name}`).sort());

  // A second report replaces the first; other files are not replaced.
  await writeFile(join(out, 'notes.txt'), 'mine');
  const refused = await scrim('rephotograph', join(base, 'ball.capture'), '--out', out, '--method', 'plain');
  expect([refused.status, refused.err]).toEqual([1, expect.stringContaining('notes.txt')]);
});
