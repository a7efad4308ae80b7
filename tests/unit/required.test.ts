import { execFile } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, expect, test } from '@jest/globals';

const ROOT = resolve(import.meta.dirname, '../..');
let folder = '';

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-required-'));
  const suite = `import { test } from '@jest/globals';
import { describeWithData } from '${ROOT}/tests/support/shared-data.ts';
describeWithData('a recording that no machine has', 'sessions/there-is-none', () => test('is read', () => {}));
test('stands beside it', () => {});`;
  await writeFile(join(folder, 'missing.test.ts'), suite);
  const config = {
    rootDir: ROOT,
    roots: [folder],
    testMatch: ['**/missing.test.ts'],
    transform: { '\\.ts$': join(ROOT, 'tests/support/transform.mjs') },
    extensionsToTreatAsEsm: ['.ts'],
    modulePaths: [join(ROOT, 'node_modules')],
  };
  await writeFile(join(folder, 'jest.config.json'), JSON.stringify(config));
});
afterAll(() => rm(folder, { recursive: true, force: true }));

/** A Jest of its own, over a suite whose data no machine has. */
function runMissing(required: string): Promise<{ readonly failed: boolean; readonly said: string }> {
  const args = [join(ROOT, 'node_modules/jest/bin/jest.js'), '--config', join(folder, 'jest.config.json')];
  const env = { ...process.env, NODE_OPTIONS: '--experimental-vm-modules', SCRIM_REQUIRE: required };
  return new Promise((done) => {
    execFile(process.execPath, args, { cwd: ROOT, env }, (error, stdout, stderr) =>
      done({ failed: error !== null, said: stdout + stderr }),
    );
  });
}

test('SCRIM_REQUIRE makes a suite that cannot run fail instead of skip', async () => {
  expect(await runMissing('')).toMatchObject({ failed: false, said: expect.stringContaining('SKIPPED a recording that no machine has') });
  expect(await runMissing('electron')).toMatchObject({ failed: false });
  expect(await runMissing('electron,data')).toMatchObject({
    failed: true,
    said: expect.stringContaining('has what SCRIM_REQUIRE names: data'),
  });
});
