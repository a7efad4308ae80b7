import { mkdtemp, rm, stat, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { makeFolders } from './make-folders.ts';

let base = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-folders-'));
});
afterEach(() => rm(base, { recursive: true, force: true }));

describe('folders', () => {
  test('are made down to the one asked for; the first new one is told', async () => {
    expect(await makeFolders(join(base, 'a', 'b', 'c'))).toBe(join(base, 'a'));
    expect((await stat(join(base, 'a', 'b', 'c'))).isDirectory()).toBe(true);
    expect(await makeFolders(join(base, 'a', 'b', 'c'))).toBeUndefined();
    expect(await makeFolders(join(base, 'a', 'd'))).toBe(join(base, 'a', 'd'));
  });

  test('may be made by two at once', async () => {
    await Promise.all(Array.from({ length: 8 }, () => makeFolders(join(base, 'x', 'y', 'z'))));
    expect((await stat(join(base, 'x', 'y', 'z'))).isDirectory()).toBe(true);
  });

  test('are refused where a file is, or below one', async () => {
    await writeFile(join(base, 'file'), '');
    await expect(makeFolders(join(base, 'file'))).rejects.toMatchObject({ code: 'EEXIST' });
    await expect(makeFolders(join(base, 'file', 'a', 'b'))).rejects.toMatchObject({ code: 'ENOTDIR' });
  });

  test('are refused behind a link that leads nowhere', async () => {
    await symlink(join(base, 'absent'), join(base, 'link'));
    await expect(makeFolders(join(base, 'link', 'a'))).rejects.toMatchObject({ code: 'EEXIST' });
  });

  const onLinux = process.platform === 'linux' ? test : test.skip;
  onLinux('are refused, and not tried for ever, where none can be made (only Linux has /proc)', async () => {
    await expect(makeFolders('/proc/scrim/page')).rejects.toMatchObject({ code: 'ENOENT' });
  });
});
