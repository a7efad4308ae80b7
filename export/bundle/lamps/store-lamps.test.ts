import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { encode as encodeJpeg } from 'jpeg-js';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import { type LampOptions, lampKey, lampsOfExposures } from '../../../nodes/kit/panorama/lamp-options.ts';
import { merge } from '../../../nodes/source/panorama-exposures/worker.ts';
import { compileExample } from '../../../tests/support/compile-project.ts';
import { decodePanorama } from '../../../tests/support/decode-panorama.ts';
import type { Program } from '../../program/program.ts';
import type { PreparedAsset } from '../assets/prepared-asset.ts';
import { bundleScripts } from '../bundle-page-script.ts';
import { programUse } from '../program-use.ts';
import { storeLamps } from './store-lamps.ts';

const ROOT = resolve(import.meta.dirname, '../../..');
const EXAMPLE = join(ROOT, 'nodes/light/from-panorama/example');
const OPTIONS: LampOptions = { method: 'solid-angle', lamps: 2, iterations: 2, intensities: 'ranks', clippedShare: 0.5 };

let program: Program;
beforeAll(async () => {
  program = await compileExample(EXAMPLE);
});

async function store(bytes: Uint8Array, of = program) {
  const said: string[] = [];
  const assets = of.assets.map(
    (asset): PreparedAsset => ({ asset, path: asset.path, bytes, copyright: '', others: [], report: {} as never }),
  );
  const stored = await storeLamps(of, assets, { root: ROOT, say: (text) => said.push(text) });
  return { lamps: stored.assets[0]?.asset.lamps, use: programUse(stored.program), said };
}

/** A dark room with a lamp of 8 × 8 pixels. */
function room(channels: 3 | 4): Uint8Array {
  const data = new Uint8Array(128 * 64 * channels).fill(40);
  for (let y = 16; y < 24; y++) data.fill(255, (y * 128 + 96) * channels, (y * 128 + 104) * channels);
  return data;
}

const png = (): Uint8Array => encode({ width: 128, height: 64, channels: 3, data: room(3) });
const jpeg = (): Uint8Array => encodeJpeg({ width: 128, height: 64, data: room(4) }, 90).data;

/** EXIF data whose only entry is the orientation, behind the start of the image. */
function turned(file: Uint8Array): Uint8Array {
  const exif = [0x45, 0x78, 0x69, 0x66, 0, 0, 0x4d, 0x4d, 0, 42, 0, 0, 0, 8, 0, 1, 0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0];
  return Uint8Array.from([...file.subarray(0, 2), 0xff, 0xe1, 0, exif.length + 2, ...exif, ...file.subarray(2)]);
}

test('an HDR file of the project: the page has its lamps, equal to those that its own search finds, and neither worker nor search', async () => {
  const path = join(EXAMPLE, 'assets/room.hdr');
  const { lamps, use, said } = await store(await readFile(path));
  const expected = findLampsAtOnce(await decodePanorama(path), OPTIONS);
  expect(expected.lamps).toHaveLength(2);
  expect(lamps).toEqual({ [lampKey(OPTIONS)]: expected });
  expect(said).toEqual(['Finding the lamps of assets/room.hdr…']);
  expect([programUse(program).workers, use.workers]).toEqual([true, false]);
  const { page } = await bundleScripts(ROOT, {
    ...use,
    decoders: [],
    models: { extensions: new Set(), points: false, open: false },
    credits: false,
    singleFile: false,
  });
  const names = Object.keys(page.parts).filter((name) => /from-panorama|kit\/panorama/.test(name));
  expect(names).toContain('nodes/light/from-panorama/runtime.ts');
  expect(names.filter((name) => /method|workers|contours/.test(name))).toEqual([]);
});

test.each([
  ['PNG', png],
  ['JPEG', jpeg],
])('a %s file is searched as its bytes', async (_format, file) => {
  const { lamps, use } = await store(file());
  const found = lamps?.[lampKey(OPTIONS)];
  expect([found?.lamps.length, found?.lamps[0]?.centerPx.map(Math.round), use.workers]).toEqual([1, [100, 20], false]);
});

test('the file of Capture panorama has its lamps too, and the page keeps the search for those that visitors take', async () => {
  const { lamps, use } = await store(png(), await compileExample(join(ROOT, 'nodes/source/panorama-capture/example')));
  expect([lamps?.[lampKey(OPTIONS)]?.lamps.length, use.workers]).toEqual([1, true]);
});

describe('shots that a node merges', () => {
  const SHOTS = join(ROOT, 'nodes/source/panorama-exposures/example');
  const FILES = ['bright', 'middle', 'dark'];

  async function storeShots(bytesOf: (id: string) => Promise<Uint8Array>) {
    const merging = await compileExample(SHOTS);
    const assets: PreparedAsset[] = [];
    for (const asset of merging.assets)
      assets.push({ asset, path: asset.path, bytes: await bytesOf(asset.id), copyright: '', others: [], report: {} as never });
    const stored = await storeLamps(merging, assets, { root: ROOT, say: () => {} });
    const lights = stored.program.operations.find((operation) => 'type' in operation && operation.type === 'light/from-panorama');
    return { stored: stored.assets.map(({ asset }) => [asset.id, asset.lamps] as const), searches: lights && 'worker' in lights };
  }

  test('are searched as they are merged; the first shot stores the lamps, and the page does not search', async () => {
    const { stored, searches } = await storeShots((id) => readFile(join(SHOTS, `assets/${id}.png`)));
    expect(searches).toBe(false);
    const lamps = Object.fromEntries(stored);
    expect([lamps.middle, lamps.dark]).toEqual([undefined, undefined]);
    const shots = await Promise.all(FILES.map((id) => decodePanorama(join(SHOTS, `assets/${id}.png`))));
    // As the worker of the page merges, and the worker of the lights searches.
    const expected = findLampsAtOnce(merge({ shots, stopsApart: 0 }).pixels, OPTIONS);
    expect(expected.lamps).toHaveLength(2);
    expect(lampsOfExposures(lamps.bright, { shots: FILES, stopsApart: 0 })).toEqual({ [lampKey(OPTIONS)]: expected });
    // Not those of the first shot alone.
    expect(lamps.bright).not.toHaveProperty([lampKey(OPTIONS)]);
  });

  test('are left to the page where they do not fit together, or one cannot be decoded here', async () => {
    for (const other of [png(), new TextEncoder().encode('RIFF....WEBP')]) {
      const { stored, searches } = await storeShots(async (id) => (id === 'dark' ? other : readFile(join(SHOTS, `assets/${id}.png`))));
      expect([stored.every(([, lamps]) => lamps === undefined), searches]).toEqual([true, true]);
    }
  });
});

test('the page itself searches what only a browser decodes, photos that it turns, and reports a damaged file', async () => {
  const webp = new TextEncoder().encode('RIFF....WEBP');
  const hdr = (await readFile(join(EXAMPLE, 'assets/room.hdr'))).subarray(0, 30);
  for (const bytes of [webp, turned(jpeg()), jpeg().subarray(0, 300), jpeg().subarray(0, 6), hdr]) {
    const { lamps, use } = await store(bytes);
    expect([lamps, use.workers]).toEqual([undefined, true]);
  }
});
