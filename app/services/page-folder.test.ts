import { chmod, mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import type { FileSink } from '../../export/bundle/bundle-page.ts';
import { NODE_FILES } from './file-layer.ts';
import { writePageFolder } from './page-folder.ts';

let base = '';
let out = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-page-'));
  out = join(base, 'site', 'page');
});
afterEach(() => rm(base, { recursive: true, force: true }));

/** A page of three files, two of them named after `version`. */
const page = (version: string) => async (sink: FileSink) => {
  const write = (path: string, text: string) => sink.write(path, new TextEncoder().encode(text));
  const paths = ['index.html', `page-${version}.js`, `assets/cup-${version}.glb`];
  for (const path of paths) await write(path, version);
  await write('report.json', JSON.stringify({ format: 'scrim-export', files: paths.map((path) => ({ path })) }));
  return version;
};

async function tree(folder: string): Promise<string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => !entry.isDirectory())
    .map((entry) => join(entry.path, entry.name).slice(folder.length + 1))
    .sort();
}

const FIRST = ['site/page/assets/cup-one.glb', 'site/page/index.html', 'site/page/page-one.js', 'site/page/report.json'];
const SECOND = ['site/page/assets/cup-two.glb', 'site/page/index.html', 'site/page/page-two.js', 'site/page/report.json'];

describe('the folder of an exported page', () => {
  test('is made, and replaced whole by the next export', async () => {
    expect(await writePageFolder(out, NODE_FILES, page('one'))).toBe('one');
    expect(await tree(base)).toEqual(FIRST);
    await writePageFolder(out, NODE_FILES, page('two'));
    expect(await tree(base)).toEqual(SECOND);
  });

  test('stays when the process ends just after it was put in place', async () => {
    const before = new Set(process.listeners('exit'));
    const rename: typeof NODE_FILES.rename = async (from, to) => {
      await NODE_FILES.rename(from, to);
      for (const listener of process.listeners('exit')) if (!before.has(listener)) listener.call(process, 0);
    };
    await writePageFolder(out, { ...NODE_FILES, rename }, page('one'));
    expect(await tree(base)).toEqual(FIRST);
  });

  test('may be an empty one, or one behind a link', async () => {
    await mkdir(out, { recursive: true });
    await writePageFolder(out, NODE_FILES, page('one'));
    await symlink(out, join(base, 'link'));
    await writePageFolder(join(base, 'link'), NODE_FILES, page('two'));
    expect(await readFile(join(out, 'index.html'), 'utf8')).toBe('two');
  });

  test('is refused, untouched, with files that Scrim did not write', async () => {
    await mkdir(out, { recursive: true });
    await writeFile(join(out, 'thesis.doc'), 'mine');
    await expect(writePageFolder(out, NODE_FILES, page('one'))).rejects.toMatchObject({ diagnostic: { code: 'SCR061' } });
    expect(await tree(base)).toEqual(['site/page/thesis.doc']);
  });

  test('is refused when something was added to an earlier export', async () => {
    await writePageFolder(out, NODE_FILES, page('one'));
    await mkdir(join(out, 'assets', 'more'));
    await writeFile(join(out, 'assets', 'more', 'photo.jpg'), 'mine');
    const refused = writePageFolder(out, NODE_FILES, page('two'));
    await expect(refused).rejects.toThrow(/assets\/more\/photo\.jpg/);
    expect(await readFile(join(out, 'index.html'), 'utf8')).toBe('one');
  });

  test('is refused where a file has the name', async () => {
    await mkdir(join(base, 'site'));
    await writeFile(out, 'mine');
    await expect(writePageFolder(out, NODE_FILES, page('one'))).rejects.toMatchObject({ diagnostic: { code: 'SCR061' } });
    expect(await readFile(out, 'utf8')).toBe('mine');
  });

  test('stays as it was when there is no page to write', async () => {
    expect(await writePageFolder(out, NODE_FILES, async () => null)).toBeNull();
    expect(await readdir(base)).toEqual([]);
    await writePageFolder(out, NODE_FILES, page('one'));
    await expect(writePageFolder(out, NODE_FILES, () => Promise.reject(new Error('fault')))).rejects.toThrow('fault');
    expect(await tree(base)).toEqual(FIRST);
  });

  test.each([
    ['ENOSPC', 'SCR062'],
    ['EROFS', 'SCR060'],
  ])('stays as it was when the disk fails at any step: %s', async (code, diagnostic) => {
    await writePageFolder(out, NODE_FILES, page('one'));
    for (let failAt = 1; failAt <= 10; failAt++) {
      let count = 0;
      const fail = <A extends unknown[]>(operation: (...args: A) => Promise<void>) => {
        return async (...args: A) => {
          if (++count === failAt) throw Object.assign(new Error(code), { code });
          return operation(...args);
        };
      };
      const { makeFolder, writeNew, rename, ...rest } = NODE_FILES;
      const files = { ...rest, makeFolder: fail(makeFolder), writeNew: fail(writeNew), rename: fail(rename) };
      await expect(writePageFolder(out, files, page('two'))).rejects.toMatchObject({ diagnostic: { code: diagnostic } });
      expect(await tree(base)).toEqual(FIRST);
    }
  });

  test('that cannot be written is refused', async () => {
    if (process.getuid?.() === 0) {
      // Root may write anywhere; what it cannot write is what is no folder.
      await writeFile(join(base, 'site'), 'a file');
    } else {
      await mkdir(join(base, 'site'));
      await chmod(join(base, 'site'), 0o500);
    }
    await expect(writePageFolder(out, NODE_FILES, page('one'))).rejects.toMatchObject({ diagnostic: { code: 'SCR060' } });
  });
});
