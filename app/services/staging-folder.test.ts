import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import process from 'node:process';
import { expect, test } from '@jest/globals';
import { startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { eventually } from '../../tests/support/patience.ts';
import { ownerOf } from './owner.ts';
import { makeStagingFolder } from './staging-folder.ts';

test('a host deletes the photographs of one that was killed, and those of no other', async () => {
  const child = spawn(process.execPath, ['-e', 'setInterval(() => {}, 1000)']);
  const left = join(tmpdir(), `scrim-photographs-${ownerOf(child.pid ?? 0)}-abcdef`);
  await mkdir(join(left, 'images'), { recursive: true });
  await writeFile(join(left, 'images/0000.png'), 'a photograph');
  const own = await makeStagingFolder();
  const foreign = join(tmpdir(), 'scrim-photographs-of-mine');
  await mkdir(foreign, { recursive: true });
  try {
    child.kill('SIGKILL');
    await once(child, 'exit');
    startHost();
    await eventually(async () => expect(await readdir(tmpdir())).not.toContain(basename(left)));
    expect(await readdir(tmpdir())).toEqual(expect.arrayContaining([basename(own), basename(foreign)]));
  } finally {
    await stopHosts();
    for (const folder of [own, foreign]) await rm(folder, { recursive: true, force: true });
  }
});
