import { spawnSync } from 'node:child_process';
import { cp, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';

const ROOT = resolve(import.meta.dirname, '../..');
const PARTS = ['app', 'bin', 'export', 'nodes', 'shader-library', 'tools', 'package.json', 'package-lock.json', 'text-modules.d.ts'];

let copy = '';
beforeAll(async () => {
  copy = await mkdtemp(join(tmpdir(), 'scrim-registry-'));
  for (const part of PARTS) await cp(join(ROOT, part), join(copy, part), { recursive: true });
  await symlink(join(ROOT, 'node_modules'), join(copy, 'node_modules'));
});
afterAll(() => rm(copy, { recursive: true, force: true }));

function start() {
  const { NODE_OPTIONS: _, ...env } = process.env;
  const { status, stderr } = spawnSync(process.execPath, [join(copy, 'bin/scrim.mjs'), '--version'], { env, encoding: 'utf8' });
  return { status, stderr };
}

describe('Scrim starts', () => {
  test('when a node folder was deleted, and when another branch left its registry behind', async () => {
    expect(start()).toMatchObject({ status: 0 });
    const registry = join(copy, 'nodes/generated/definitions.gen.ts');
    const before = await readFile(registry, 'utf8');
    expect(before).toContain('value/latch');
    await rm(join(copy, 'nodes/value/latch'), { recursive: true });
    expect(start()).toMatchObject({ status: 0 });
    expect(await readFile(registry, 'utf8')).not.toContain('value/latch');
    // As `npm test` on a branch that has the folder leaves it.
    await writeFile(registry, before);
    await writeFile(join(copy, 'app/touched.ts'), '');
    expect(start()).toMatchObject({ status: 0 });
    expect(await readFile(registry, 'utf8')).not.toContain('value/latch');
  });
});
