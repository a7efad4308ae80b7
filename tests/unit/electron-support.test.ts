import { chmod, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, describe, expect, test } from '@jest/globals';
import { findElectron } from '../support/electron.ts';

/** Leaving Electron tests out is only honest when the reason is printed, so the reasons are tested where no Electron is needed. */
describe('finding an Electron to test with', () => {
  const { ELECTRON_OVERRIDE_DIST_PATH: before, DISPLAY: display, PATH: path } = process.env;
  const folders: string[] = [];

  afterEach(async () => {
    for (const [name, value] of Object.entries({ ELECTRON_OVERRIDE_DIST_PATH: before, DISPLAY: display, PATH: path })) {
      if (value === undefined) delete process.env[name];
      else process.env[name] = value;
    }
    for (const folder of folders.splice(0)) await rm(folder, { recursive: true });
  });

  async function distWith(files: Readonly<Record<string, string>>): Promise<string> {
    const folder = await mkdtemp(join(tmpdir(), 'scrim-dist-'));
    folders.push(folder);
    for (const [name, text] of Object.entries(files)) {
      await writeFile(join(folder, name), text);
      await chmod(join(folder, name), 0o755);
    }
    process.env.ELECTRON_OVERRIDE_DIST_PATH = folder;
    return folder;
  }

  test('a folder without the binary', async () => {
    await distWith({});
    expect(await findElectron()).toEqual({ missing: expect.stringContaining('no Electron binary') });
  });

  test('no display and no Xvfb', async () => {
    const folder = await distWith({ electron: '#!/bin/sh\n' });
    delete process.env.DISPLAY;
    process.env.PATH = folder;
    expect(await findElectron()).toEqual({ missing: expect.stringContaining('no display') });
  });

  test('a binary and a display', async () => {
    const folder = await distWith({ electron: '#!/bin/sh\n' });
    process.env.DISPLAY = ':7';
    expect(await findElectron()).toEqual({ executablePath: join(folder, 'electron') });
  });
});
