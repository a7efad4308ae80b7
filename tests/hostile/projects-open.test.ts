import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { compileFolder } from '../../app/cli/compile-folder.ts';
import { HostError } from '../../app/contract/host-error.ts';
import { checkAssets } from '../../app/services/check-assets.ts';
import type { HostService } from '../../app/services/host.ts';
import { openWindow, startHost, stopHosts } from '../support/host-kit.ts';
import { projectText } from '../support/project-kit.ts';
import { hostileProjects } from './hostile-projects.ts';

let base = '';
let host: HostService;
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-hostile-'));
  host = startHost();
});
afterAll(async () => {
  stopHosts();
  await rm(base, { recursive: true, force: true });
});

/** Ends a test that hangs; no test here takes a tenth of it. */
const BOUND_MS = 60_000;
const PROJECTS = hostileProjects();

/** What the editor and `scrim check` do with a folder. Answers with the refusals, which are in words for a person. */
async function useFolder(root: string): Promise<readonly HostError[]> {
  const window = openWindow(host, root);
  const refused: HostError[] = [];
  const attempt = async <T>(task: () => Promise<T>): Promise<T | null> => {
    try {
      return await task();
    } catch (error) {
      if (!(error instanceof HostError)) throw error;
      refused.push(error);
      return null;
    }
  };
  const opened = await attempt(() => window.call('project.open', { path: root }));
  if (opened) {
    const { handle, files, revision } = opened;
    await attempt(() => window.call('session.list', { handle }));
    await attempt(() => window.call('asset.read', { handle, path: 'assets/hostile.png' }));
    await attempt(() => window.call('asset.import', { handle, name: 'hostile.png', bytes: Uint8Array.from([1, 2, 3]) }));
    await attempt(() => window.call('project.autosave', { handle, files }));
    const next = { ...files, layout: '{}\n', sources: { ...files.sources, 'hostile.fs': 'void main() {}\n' } };
    await attempt(() => window.call('project.save', { handle, files: next, revision, overwrite: false }));
    await attempt(() => window.call('project.save', { handle, files: next, revision, overwrite: true }));
    await attempt(() => window.call('project.save-as', { handle, path: `${root}-copy`, files }));
    for (const path of ['assets/hostile.png', 'project.scrim.json']) {
      const answer = await host.content.answer('preview', 'GET', `${new URL(opened.assetBaseUrl).pathname}${path}`);
      answer.body.destroy();
    }
    await window.call('project.close', { handle });
  }
  await attempt(() => compileFolder(root));
  await checkAssets(root, { hostile: { kind: 'image', path: 'assets/hostile.png' } }, new Set());
  window.leave();
  return refused;
}

async function within<T>(ms: number, task: Promise<T>): Promise<T> {
  let timer: NodeJS.Timeout | undefined;
  const late = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new Error(`It hangs: no result after ${ms / 1000} s.`)), ms);
  });
  return Promise.race([task, late]).finally(() => clearTimeout(timer));
}

describe('a project made to do harm opens, or is refused in clear words, in bounded time, and touches nothing outside', () => {
  test('there are more than a hundred of them', () => {
    expect(PROJECTS.length).toBeGreaterThan(100);
    expect(new Set(PROJECTS.map(({ name }) => name)).size).toBe(PROJECTS.length);
  });

  test.each(PROJECTS)('$name', async ({ make }) => {
    const folder = await mkdtemp(join(base, 'case-'));
    const root = join(folder, 'project');
    const outside = join(folder, 'outside');
    await mkdir(root);
    await mkdir(outside);
    await writeFile(join(outside, 'secret.txt'), 'secret');
    await writeFile(join(root, 'project.scrim.json'), projectText({ title: 'Hostile', nodes: {}, wires: [] }));
    await make(root, outside);
    const refused = await within(BOUND_MS, useFolder(root));
    for (const { diagnostic } of refused) {
      // A fault of our own is no clear refusal.
      expect(diagnostic.code).not.toBe('SCR074');
      expect(diagnostic.message).toMatch(/\S{3,}.*\.$/s);
    }
    expect(await readdir(outside)).toEqual(['secret.txt']);
    expect(await readFile(join(outside, 'secret.txt'), 'utf8')).toBe('secret');
    expect((await readdir(folder)).filter((name) => !['project', 'outside', 'project-copy'].includes(name))).toEqual([]);
    const copied = await readdir(`${root}-copy`, { recursive: true, withFileTypes: true }).catch(() => []);
    for (const entry of copied.filter((one) => one.isFile())) {
      expect(await readFile(join(entry.path, entry.name), 'utf8')).not.toBe('secret');
    }
    await rm(folder, { recursive: true, force: true });
  });
});
