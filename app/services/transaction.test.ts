import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { realFolder } from './confine.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import { finishInterrupted, writeAll } from './transaction.ts';

const bytes = (text: string) => new TextEncoder().encode(text);

/** One file of each kind: changed, new, removed. */
const CHANGES = new Map([
  ['project.scrim.json', bytes('new project')],
  ['project.layout.json', bytes('new layout')],
  ['shaders/fresh.fs', bytes('new shader')],
  ['shaders/gone.fs', null],
]);
const OLD = { 'project.scrim.json': 'old project', 'project.layout.json': 'old layout', 'shaders/gone.fs': 'old shader' };
const NEW = { 'project.scrim.json': 'new project', 'project.layout.json': 'new layout', 'shaders/fresh.fs': 'new shader' };

let root = '';
beforeEach(async () => {
  root = await realFolder(await mkdtemp(join(tmpdir(), 'scrim-save-')));
  await mkdir(join(root, 'shaders'));
  for (const [path, text] of Object.entries(OLD)) await writeFile(join(root, path), text);
});
afterEach(() => rm(root, { recursive: true, force: true }));

async function contents(): Promise<Record<string, string>> {
  const found: Record<string, string> = {};
  for (const name of await readdir(root, { recursive: true, withFileTypes: true })) {
    const path = join(name.path, name.name).slice(root.length + 1);
    if (name.isFile() && path !== '.scrim/.gitignore') found[path] = await readFile(join(root, path), 'utf8');
  }
  return found;
}

class Killed extends Error {}

type Fault = 'ENOSPC' | 'EACCES' | 'killed';

/**
 * Breaks at the `failAt`th operation that changes something. `killed`: nothing works from then on, as for a process that died;
 * else the one operation fails, having written half of what it should, and the following ones work.
 */
function breakingFiles(failAt: number, fault: Fault): { files: FileLayer; operations: () => number } {
  let count = 0;
  const guard = async <T>(operation: () => Promise<T>, onFault?: () => Promise<unknown>): Promise<T> => {
    count++;
    if (fault === 'killed' && count > failAt) throw new Killed();
    if (count !== failAt) return operation();
    await onFault?.();
    throw fault === 'killed' ? new Killed() : Object.assign(new Error(fault), { code: fault });
  };
  return {
    operations: () => count,
    files: {
      writeNew: (path, content) =>
        guard(
          () => NODE_FILES.writeNew(path, content),
          () => NODE_FILES.writeNew(path, content.subarray(0, content.length / 2)),
        ),
      rename: (from, to) => guard(() => NODE_FILES.rename(from, to)),
      link: (from, to) => guard(() => NODE_FILES.link(from, to)),
      remove: (path) => guard(() => NODE_FILES.remove(path)),
      makeFolder: (path) => guard(() => NODE_FILES.makeFolder(path)),
      syncFolder: (path) => guard(() => NODE_FILES.syncFolder(path)),
    },
  };
}

async function operationsOfOneSave(): Promise<number> {
  const counting = breakingFiles(Number.POSITIVE_INFINITY, 'ENOSPC');
  await writeAll(root, CHANGES, counting.files);
  return counting.operations();
}

async function startOver(): Promise<void> {
  await rm(root, { recursive: true });
  await mkdir(join(root, 'shaders'), { recursive: true });
  for (const [path, text] of Object.entries(OLD)) await writeFile(join(root, path), text);
}

describe('a save of several files', () => {
  test('writes, adds and removes, and leaves nothing behind', async () => {
    await writeAll(root, CHANGES, NODE_FILES);
    expect(await contents()).toEqual(NEW);
  });

  test.each(['ENOSPC', 'EACCES'] as const)('leaves every old file as it was when any one operation fails: %s', async (fault) => {
    const operations = await operationsOfOneSave();
    expect(operations).toBeGreaterThan(15);
    const outcomes: string[] = [];
    for (let failAt = 1; failAt <= operations; failAt++) {
      await startOver();
      const saved = await writeAll(root, CHANGES, breakingFiles(failAt, fault).files).then(
        () => true,
        () => false,
      );
      const now = await contents();
      // What fails after the last rename can only leave rubbish in Scrim's own folder; what is saved stays saved.
      const own = Object.fromEntries(Object.entries(now).filter(([path]) => !path.startsWith('.scrim/')));
      outcomes.push(JSON.stringify(own) === JSON.stringify(sorted(saved ? NEW : OLD)) ? 'whole' : `${failAt}: ${JSON.stringify(own)}`);
    }
    expect(new Set(outcomes)).toEqual(new Set(['whole']));
  });

  test('is whole at the next opening wherever the process died: all old or all new', async () => {
    const operations = await operationsOfOneSave();
    const seen = new Set<string>();
    for (let failAt = 1; failAt <= operations; failAt++) {
      await startOver();
      await writeAll(root, CHANGES, breakingFiles(failAt, 'killed').files).catch(() => {});
      await finishInterrupted(root, NODE_FILES);
      const own = Object.fromEntries(Object.entries(await contents()).filter(([path]) => !path.startsWith('.scrim/')));
      seen.add(JSON.stringify(own));
    }
    expect([...seen].sort()).toEqual([JSON.stringify(sorted(NEW)), JSON.stringify(sorted(OLD))].sort());
  });

  test('is whole when the opening that finishes it dies too', async () => {
    const operations = await operationsOfOneSave();
    for (let failAt = 1; failAt <= operations; failAt++) {
      for (let again = 1; again <= 6; again++) {
        await startOver();
        await writeAll(root, CHANGES, breakingFiles(failAt, 'killed').files).catch(() => {});
        await finishInterrupted(root, breakingFiles(again, 'killed').files).catch(() => {});
        await finishInterrupted(root, NODE_FILES);
        const own = Object.fromEntries(Object.entries(await contents()).filter(([path]) => !path.startsWith('.scrim/')));
        expect([JSON.stringify(sorted(NEW)), JSON.stringify(sorted(OLD))]).toContain(JSON.stringify(own));
      }
    }
  });

  test('takes a journal that was tampered with for nothing', async () => {
    await mkdir(join(root, '.scrim'));
    for (const journal of ['not json', '{}', '{"direction":"forward","staging":"../../x","changes":[]}']) {
      await writeFile(join(root, '.scrim', 'save.json'), journal);
      await finishInterrupted(root, NODE_FILES);
    }
    expect(await contents()).toEqual(OLD);
  });

  test('refuses a journal that leads out of the project', async () => {
    await mkdir(join(root, '.scrim'));
    const journal = { direction: 'forward', staging: '.scrim/save-0123456789ab', changes: [{ path: '../x', action: 'remove', had: true }] };
    await writeFile(join(root, '.scrim', 'save.json'), JSON.stringify(journal));
    await expect(finishInterrupted(root, NODE_FILES)).rejects.toThrow(/outside the project folder/);
  });
});

function sorted(record: Readonly<Record<string, string>>): Record<string, string> {
  return Object.fromEntries(Object.entries(record).sort(([a], [b]) => (a < b ? -1 : 1)));
}
