import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { beforeAll, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import { type LampOptions, lampKey } from '../../../nodes/kit/panorama/lamp-options.ts';
import { compileExample } from '../../../tests/support/compile-project.ts';
import { decodePanorama } from '../../../tests/support/decode-panorama.ts';
import type { Program } from '../../program/program.ts';
import type { PreparedAsset } from '../assets/prepare-assets.ts';
import { bundleScript } from '../bundle-page-script.ts';
import { programUse } from '../program-use.ts';
import { storeLamps } from './store-lamps.ts';

const ROOT = resolve(import.meta.dirname, '../../..');
const EXAMPLE = join(ROOT, 'nodes/light/from-panorama/example');
const OPTIONS: LampOptions = { method: 'solid-angle', lamps: 2, iterations: 2, intensities: 'ranks', clippedShare: 0.5 };

let program: Program;
beforeAll(async () => {
  program = await compileExample(EXAMPLE);
});

async function store(bytes: Uint8Array) {
  const said: string[] = [];
  const assets = program.assets.map((asset): PreparedAsset => ({ asset, path: asset.path, bytes, copyright: '', report: {} as never }));
  const stored = await storeLamps(program, assets, { root: ROOT, say: (text) => said.push(text) });
  return { lamps: stored.assets[0]?.asset.lamps, use: programUse(stored.program), said };
}

/** A dark room with a lamp of 4 × 4 pixels. */
function png(): Uint8Array {
  const data = new Uint8Array(64 * 32 * 3).fill(40);
  for (let y = 10; y < 14; y++) data.fill(255, (y * 64 + 46) * 3, (y * 64 + 50) * 3);
  return encode({ width: 64, height: 32, channels: 3, data });
}

test('an HDR file of the project: the page has its lamps, equal to those that its own search finds, and neither worker nor search', async () => {
  const path = join(EXAMPLE, 'assets/room.hdr');
  const { lamps, use, said } = await store(await readFile(path));
  const expected = findLampsAtOnce(await decodePanorama(path), OPTIONS);
  expect(expected.lamps).toHaveLength(2);
  expect(lamps).toEqual({ [lampKey(OPTIONS)]: expected });
  expect(said).toEqual(['Finding the lamps of assets/room.hdr…']);
  expect([programUse(program).workers, use.workers]).toEqual([true, false]);
  const { parts } = await bundleScript(ROOT, use, { decoders: [], glass: false });
  const names = Object.keys(parts).filter((name) => /from-panorama|kit\/panorama/.test(name));
  expect(names).toContain('nodes/light/from-panorama/runtime.ts');
  expect(names.filter((name) => /method|workers|contours/.test(name))).toEqual([]);
});

test('a PNG file is searched as its bytes', async () => {
  const bytes = png();
  const { lamps } = await store(bytes);
  const found = lamps?.[lampKey(OPTIONS)];
  expect([found?.lamps.length, found?.lamps[0]?.centerPx.map(Math.round)]).toEqual([1, [48, 12]]);
});

test('the page itself searches what only a browser decodes, and reports a damaged file', async () => {
  const jpeg = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 16);
  const hdr = (await readFile(join(EXAMPLE, 'assets/room.hdr'))).subarray(0, 30);
  for (const bytes of [jpeg, hdr]) {
    const { lamps, use } = await store(bytes);
    expect([lamps, use.workers]).toEqual([undefined, true]);
  }
});
