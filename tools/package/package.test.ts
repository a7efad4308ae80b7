import { mkdir, mkdtemp, readFile, rm, stat, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { printNotices, readNotices } from './notices.ts';
import { packagerOptions } from './packager-options.ts';
import { readTarget, type Target } from './target.ts';
import { zipFolder } from './zip.ts';

describe('what is packaged', () => {
  test('is this system unless told otherwise', () => {
    expect(readTarget([])).toEqual({ platform: process.platform, arch: process.arch, electron: null, out: 'dist/app' });
    const args = ['--platform', 'win32', '--arch', 'arm64', '--electron', '/opt/electron', '--out', 'there'];
    expect(readTarget(args)).toEqual({ platform: 'win32', arch: 'arm64', electron: '/opt/electron', out: 'there' });
  });

  test.each([['--platform', 'beos'], ['--arch', 'ia32'], ['--nothing']])('refuses %s %s', (...args) => {
    expect(() => readTarget(args)).toThrow(/--platform beos: there are linux, win32, darwin|--arch ia32: there are|Unknown option/);
  });

  test.each(['linux', 'win32', 'darwin'] as const)('has a name, an icon and what is outside its archive: %s', async (platform) => {
    const target: Target = { platform, arch: 'x64', electron: null, out: '/out' };
    const root = process.cwd();
    const options = packagerOptions({ target, root, staged: '/staged', electronVersion: '45.0.0', zips: null, version: '1.2.3' });
    expect(options).toMatchObject({ platform, arch: 'x64', dir: '/staged', out: '/out', executableName: 'scrim', appVersion: '1.2.3' });
    expect(options.asar).toEqual({ unpackDir: 'sources' });
    expect(options.electronZipDir).toBeUndefined();
    const extension = { linux: 'png', win32: 'ico', darwin: 'icns' }[platform];
    expect((await stat(`${options.icon}.${extension}`)).isFile()).toBe(true);
  });

  test('on macOS, folders that end in .scrim are its documents', () => {
    const target: Target = { platform: 'darwin', arch: 'arm64', electron: null, out: '/out' };
    const { extendInfo } = packagerOptions({ target, root: '/', staged: '/s', electronVersion: '45.0.0', zips: '/zips', version: '1.2.3' });
    expect(extendInfo).toMatchObject({ CFBundleDocumentTypes: [{ CFBundleTypeExtensions: ['scrim'], LSTypeIsPackage: true }] });
  });
});

describe('the notices of others', () => {
  test('name every package that the app is made of, with its license, its text and where its sources are', async () => {
    const notices = await readNotices(process.cwd());
    const { dependencies } = JSON.parse(await readFile('package.json', 'utf8')) as { dependencies: Record<string, string> };
    const names = notices.map(({ name }) => name);
    expect(names).toEqual(expect.arrayContaining(Object.keys(dependencies)));
    // Of others in turn: React's scheduler, and Monaco's cleaner of HTML.
    expect(names).toEqual(expect.arrayContaining(['scheduler', 'dompurify']));
    expect(notices.filter(({ license, source }) => license === '' || source === null)).toEqual([]);
    const text = printNotices(notices);
    for (const [name, license, words] of [
      ['elkjs', 'EPL-2.0 OR GPL-3.0-or-later', 'Eclipse Public License'],
      ['mediabunny', 'MPL-2.0', 'Mozilla Public License Version 2.0'],
      ['three', 'MIT', 'three.js authors'],
    ]) {
      expect(text).toContain(`${name} ${notices.find((notice) => notice.name === name)?.version} (${license})`);
      expect(text).toContain(words);
    }
    // What is used to build and to test is not in the app.
    expect(names).not.toEqual(expect.arrayContaining(['axe-core']));
  });
});

describe('the ZIP of an unpacked Electron', () => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-zip-'));
    await mkdir(join(base, 'electron', 'resources', 'app'), { recursive: true });
    await mkdir(join(base, 'electron', 'locales'));
    await writeFile(join(base, 'electron', 'electron'), 'program', { mode: 0o755 });
    await writeFile(join(base, 'electron', 'locales', 'ünï.pak'), 'words');
    await writeFile(join(base, 'electron', 'resources', 'app', 'main.js'), 'another app');
    await symlink('electron', join(base, 'electron', 'link'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('holds names, bytes, modes and links, and not what is skipped', async () => {
    const path = join(base, 'electron.zip');
    await zipFolder(join(base, 'electron'), path, (name) => name.startsWith('resources/app/'));
    expect(readZip(await readFile(path))).toEqual([
      { name: 'electron', mode: 0o100755, text: 'program' },
      { name: 'link', mode: 0o120777, text: 'electron' },
      { name: 'locales/ünï.pak', mode: 0o100644, text: 'words' },
    ]);
  });
});

/** From its directory at the end, as readers do (APPNOTE 4.3.16, 4.3.12, 4.3.7). */
function readZip(zip: Buffer): { name: string; mode: number; text: string }[] {
  const end = zip.lastIndexOf(Buffer.from([0x50, 0x4b, 5, 6]));
  let at = zip.readUInt32LE(end + 16);
  return Array.from({ length: zip.readUInt16LE(end + 10) }, () => {
    expect(zip.readUInt32LE(at)).toBe(0x02014b50);
    // Stored as they are.
    expect(zip.readUInt16LE(at + 10)).toBe(0);
    const size = zip.readUInt32LE(at + 20);
    const nameLength = zip.readUInt16LE(at + 28);
    const name = zip.toString('utf8', at + 46, at + 46 + nameLength);
    const mode = zip.readUInt32LE(at + 38) >>> 16;
    const local = zip.readUInt32LE(at + 42);
    expect(zip.readUInt32LE(local)).toBe(0x04034b50);
    const start = local + 30 + zip.readUInt16LE(local + 26) + zip.readUInt16LE(local + 28);
    const bytes = zip.subarray(start, start + size);
    at += 46 + nameLength + zip.readUInt16LE(at + 30) + zip.readUInt16LE(at + 32);
    return { name, mode, text: bytes.toString() };
  });
}
