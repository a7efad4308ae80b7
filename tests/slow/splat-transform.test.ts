import { spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { readSplatPly } from '../../nodes/kit/splats/splat-ply.ts';
import { SplatError } from '../../nodes/kit/splats/splats.ts';
import type { SplatShot } from '../browser/splats.page.ts';
import { useModule } from '../support/browser.ts';
import { describeMissing } from '../support/required.ts';
import { plyOf, splatCloud } from '../support/splat-files.ts';

/*
 * Files that splat-transform writes, the program of those who specified SOG. With its dependencies it takes 210 MB, so it is not among ours.
 */
const program = process.env.SCRIM_SPLAT_TRANSFORM || 'splat-transform';
const found = spawnSync(program, ['--version']).status === 0;
const REASON =
  'splat-transform is not in PATH (npm install -g @playcanvas/splat-transform@2.7.1), and SCRIM_SPLAT_TRANSFORM does not name it';

const page = useModule('tests/browser/splats.page.ts');
const VIEW = { eye: [0.3, 0.2, 0.4], target: [0, 0, -2], widthPx: 160, heightPx: 120 } as const;
const shoot = (bytes: Uint8Array, name: string): Promise<SplatShot> => page.call('draw', { bytes: Uint8Array.from(bytes), name, ...VIEW });

function difference(a: SplatShot, b: SplatShot): { readonly mean: number; readonly largest: number } {
  const apart = a.pixels.map((value, i) => Math.abs(value - (b.pixels[i] ?? 0)));
  return { mean: apart.reduce((sum, value) => sum + value, 0) / apart.length, largest: Math.max(...apart) };
}

function tests(): void {
  let folder = '';
  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'scrim-splats-'));
  });
  afterAll(() => rm(folder, { recursive: true, force: true }));

  function convert(from: string, to: string): void {
    const { status, stderr, stdout } = spawnSync(program, ['--gpu', 'cpu', '--overwrite', from, to], { cwd: folder, encoding: 'utf8' });
    if (status !== 0) throw new Error(`splat-transform failed: ${stdout}${stderr}`);
  }

  test.each([0, 3, 8, 15])('PLY and SOG with %i harmonics show what they were written from', async (coefficients) => {
    const source = plyOf(splatCloud(300, coefficients));
    await writeFile(join(folder, 'a.ply'), source);
    convert('a.ply', 'again.ply');
    convert('a.ply', 'a.sog');
    convert('a.sog', 'of-sog.ply');
    const file = (name: string): Promise<SplatShot> => readFile(join(folder, name)).then((bytes) => shoot(bytes, name));
    const first = await shoot(source, 'a.ply');
    expect(difference(await file('again.ply'), first).largest).toBeLessThanOrEqual(1);
    const sog = await file('a.sog');
    expect(sog.count).toBe(300);
    // The program and Scrim read the same numbers of the SOG file.
    expect(difference(sog, await file('of-sog.ply')).largest).toBeLessThanOrEqual(1);
    // SOG itself loses a little: codebooks of 256 numbers, and a palette of harmonics.
    expect(difference(sog, first).mean).toBeLessThan(2.5);
  });

  test('its compressed PLY is refused with what to do', async () => {
    await writeFile(join(folder, 'a.ply'), plyOf(splatCloud(300, 0)));
    convert('a.ply', 'a.compressed.ply');
    const bytes = await readFile(join(folder, 'a.compressed.ply'));
    expect(() => readSplatPly(bytes)).toThrow(SplatError);
    expect(() => readSplatPly(bytes)).toThrow('it is a compressed PLY file of SuperSplat');
  });
}

if (found) describe('files of splat-transform', tests);
else describeMissing('files of splat-transform', 'splat-transform', REASON);
