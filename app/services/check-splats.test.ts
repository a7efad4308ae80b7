import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { plyFile, plyOf, splatAt } from '../../tests/support/splat-files.ts';
import { sogOf } from '../../tools/examples/splats/write-sog.ts';
import { checkAssets } from './check-assets.ts';
import { manySplats } from './check-splats.ts';

let root: string;
beforeEach(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-check-splats-'));
  await mkdir(join(root, 'assets'));
});
afterEach(() => rm(root, { recursive: true, force: true }));

async function said(name: string, bytes: Uint8Array): Promise<string[]> {
  await writeFile(join(root, 'assets', name), bytes);
  const found = await checkAssets(root, { a: { path: `assets/${name}`, kind: 'splats' } }, new Set(['a']));
  return found.map(({ severity, code, message, fix }) => `${severity} ${code} ${message} ${fix ?? ''}`);
}

test('splats are checked before a page is exported: their format, and that the file is complete', async () => {
  const splats = [splatAt(0, 0, 0), splatAt(1, 0, 0)];
  expect(await said('a.ply', plyOf(splats))).toEqual([]);
  expect(await said('a.sog', await sogOf(splats))).toEqual([]);
  expect(await said('b.ply', plyOf(splats).subarray(0, -4))).toEqual([
    'error SCR032 assets/b.ply cannot be shown: it is incomplete: it has 1 of 2 splats. Export it again from the program that made it.',
  ]);
  const mesh = plyFile(1, ['x', 'y', 'z'], [0, 0, 0], 'element face 1\nproperty list uchar int vertex_indices\n');
  expect(await said('c.ply', mesh)).toEqual([
    'error SCR032 assets/c.ply cannot be shown: this PLY file holds a mesh, not splats. Save the mesh as .glb and import it as a model.',
  ]);
  expect(await said('d.sog', Uint8Array.of(1, 2, 3))).toEqual([
    'error SCR032 assets/d.sog cannot be shown: its archive is incomplete. Export it again from the program that made it.',
  ]);
  expect(await said('e.ply', new Uint8Array())).toEqual(['error SCR032 assets/e.ply is empty. Export it again, or choose another file.']);
});

test('many splats give a warning that names the devices on which a page is slow', () => {
  expect(manySplats(500_000)).toBeNull();
  expect(manySplats(500_001)?.message).toBe('has 500001 splats; pages with more than 500000 are slow on headsets.');
  expect(manySplats(1_000_001)?.message).toBe('has 1000001 splats; pages with more than 1000000 are slow on phones and headsets.');
});
