import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { chmod, mkdir, mkdtemp, readdir, readFile, rename, rm, utimes, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { eventually } from '../../tests/support/patience.ts';
import type { HostEvent, HostOutput } from '../contract/contract.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import type { HostService } from './host.ts';
import { OWNER, ownerOf } from './owner.ts';

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-windows-'));
  project = join(base, 'project');
  await mkdir(join(project, 'shaders'), { recursive: true });
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

const retitled = (files: HostOutput<'project.open'>['files'], title: string) => ({ ...files, project: `{"title":"${title}"}\n` });

describe('two windows on one project', () => {
  test('the second is told, the first was not; one that was reloaded is no other', async () => {
    const host = startHost();
    const first = openWindow(host, 'a');
    expect((await first.call('project.open', { path: project })).openElsewhere).toBe(false);
    expect((await first.call('project.open', { path: project })).openElsewhere).toBe(false);
    const second = openWindow(host, 'b');
    const there = await second.call('project.open', { path: project });
    expect(there.openElsewhere).toBe(true);
    second.leave();
    expect((await openWindow(host, 'b2').call('project.open', { path: project })).openElsewhere).toBe(true);
    first.leave();
    await second.call('project.close', { handle: there.handle });
    expect((await readdir(join(project, '.scrim'))).filter((name) => name.startsWith('window-'))).toHaveLength(1);
    stopHosts();
    expect((await openWindow(startHost(), 'c').call('project.open', { path: project })).openElsewhere).toBe(false);
  });

  test('the second hears of what the first saves, and cannot save over it unasked', async () => {
    const host = startHost();
    const first = openWindow(host, 'a');
    const second = openWindow(host, 'b');
    const mine = await first.call('project.open', { path: project });
    const theirs = await second.call('project.open', { path: project });
    const heard = nextEvent(host);
    const saved = retitled(mine.files, 'Mine');
    const { revision } = await first.call('project.save', { handle: mine.handle, files: saved, revision: mine.revision, overwrite: false });
    expect(await heard).toEqual({ kind: 'project-changed-outside', handle: theirs.handle, revision });
    const over = { handle: theirs.handle, files: retitled(theirs.files, 'Theirs'), revision: theirs.revision };
    await expect(second.call('project.save', { ...over, overwrite: false })).rejects.toMatchObject({ diagnostic: { code: 'SCR063' } });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe(saved.project);
    await second.call('project.save', { ...over, overwrite: true });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Theirs"}\n');
  });

  test('each keeps its own unsaved work, and gets none of the other’s', async () => {
    const host = startHost();
    const first = openWindow(host, 'a');
    const second = openWindow(host, 'b');
    const mine = await first.call('project.open', { path: project });
    await first.call('project.autosave', { handle: mine.handle, files: retitled(mine.files, 'Unsaved, first') });
    for (const name of await readdir(join(project, '.scrim'))) {
      if (name.startsWith('unsaved-')) await utimes(join(project, '.scrim', name), new Date(0), new Date(0));
    }
    const theirs = await second.call('project.open', { path: project });
    expect(theirs.recovery).toBeNull();
    await second.call('project.autosave', { handle: theirs.handle, files: retitled(theirs.files, 'Unsaved, second') });
    // Both windows die. Each one's work is offered in turn, the newer first.
    first.leave();
    second.leave();
    const third = openWindow(host, 'c');
    const again = await third.call('project.open', { path: project });
    expect(again.recovery?.project).toContain('Unsaved, second');
    await third.call('project.autosave', { handle: again.handle, files: null });
    expect((await third.call('project.open', { path: project })).recovery?.project).toContain('Unsaved, first');
  });

  test('what was given up is not offered again, nor what was saved in the end', async () => {
    const host = startHost();
    const first = openWindow(host, 'a');
    const mine = await first.call('project.open', { path: project });
    await first.call('project.autosave', { handle: mine.handle, files: retitled(mine.files, 'Given up') });
    await first.call('project.autosave', { handle: mine.handle, files: null });
    first.leave();
    expect((await openWindow(host, 'b').call('project.open', { path: project })).recovery).toBeNull();
  });
});

test('what reloaded pages left open makes room, what a window shows stays open', async () => {
  const host = startHost();
  const window = openWindow(host, 'stays');
  const { handle, files, revision } = await window.call('project.open', { path: project });
  for (let i = 0; i < 40; i++) {
    const page = openWindow(host, `page${i}`);
    await page.call('project.open', { path: project });
    page.leave();
  }
  await window.call('project.save', { handle, files: retitled(files, 'Still open'), revision, overwrite: false });
});

describe('two processes on one project', () => {
  test('saves take turns: each of many at once is complete, and the later ones report the earlier', async () => {
    const windows = Array.from({ length: 6 }, (_, i) => openWindow(startHost(), `w${i}`));
    const opened = await Promise.all(windows.map((window) => window.call('project.open', { path: project })));
    const outcomes = await Promise.all(
      windows.map(async (window, i) => {
        const { handle, revision } = opened[i] as HostOutput<'project.open'>;
        const text = `${i}${'x'.repeat(5000)}`;
        const files = {
          project: JSON.stringify({ title: text }),
          layout: JSON.stringify({ at: text }),
          sources: { [`own-${i}.fs`]: text },
        };
        return window.call('project.save', { handle, files, revision, overwrite: false }).then(
          () => 'saved',
          (error: { diagnostic: { code: string } }) => error.diagnostic.code,
        );
      }),
    );
    expect(outcomes.filter((outcome) => outcome === 'saved')).toHaveLength(1);
    expect(outcomes.filter((outcome) => outcome === 'SCR063')).toHaveLength(5);
    const winner = outcomes.indexOf('saved');
    expect(await readdir(join(project, 'shaders'))).toEqual([`own-${winner}.fs`]);
    for (const name of ['project.scrim.json', 'project.layout.json']) {
      expect(await readFile(join(project, name), 'utf8')).toContain(`"${winner}x`);
    }
  });

  test('what a living process has unsaved, or shows, is its own; what a dead one left is not', async () => {
    const { NODE_OPTIONS: _, ...env } = process.env;
    const child = spawn(process.execPath, ['-e', 'setInterval(() => {}, 1000)'], { env, stdio: 'ignore' });
    const owner = ownerOf(child.pid ?? 0);
    const work = { project: '{"title":"Unsaved"}\n', layout: null, sources: {} };
    await mkdir(join(project, '.scrim'));
    const unsaved = join(project, '.scrim', `unsaved-${owner}-${'a'.repeat(32)}.json`);
    await writeFile(unsaved, JSON.stringify(work));
    await writeFile(join(project, '.scrim', `window-${owner}-${'a'.repeat(32)}`), '');
    const window = openWindow(startHost(), 'a');
    const beside = await window.call('project.open', { path: project });
    expect([beside.recovery, beside.openElsewhere]).toEqual([null, true]);
    const ended = once(child, 'exit');
    child.kill('SIGKILL');
    await ended;
    const after = await window.call('project.open', { path: project });
    expect([after.recovery, after.openElsewhere]).toEqual([work, false]);
  });

  test('a lock of a dead process is broken, one of a living process is waited for', async () => {
    const window = openWindow(startHost(), 'a');
    const { handle, files, revision } = await window.call('project.open', { path: project });
    const lock = join(project, '.scrim', 'lock');
    await writeFile(lock, OWNER.replace(/-\d+-/, '-999999999-'));
    const { revision: next } = await window.call('project.save', { handle, files: retitled(files, 'Two'), revision, overwrite: false });
    await writeFile(lock, ownerOf(process.ppid));
    let saved = false;
    const save = window.call('project.save', { handle, files: retitled(files, 'Three'), revision: next, overwrite: false });
    void save.then(() => {
      saved = true;
    });
    await readdir(project);
    expect(saved).toBe(false);
    await rm(lock);
    await save;
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Three"}\n');
  });
});

describe('a lock that was left', () => {
  const AHEAD_MS = 24 * 3600 * 1000;
  const elsewhere = OWNER.replace(/^[0-9a-f]{8}/, '00000000');
  const reused = OWNER.replace(/-\d+-\d+$/, `-${process.ppid}-1`);
  const running = () => ownerOf(process.ppid);

  test.each([
    ['of another machine', () => elsewhere, -61_000],
    ['of another machine, dated in the future', () => elsewhere, AHEAD_MS],
    ['of a process that runs, and does not touch it', running, -61_000],
    ['of a process whose number another one has now', () => reused, 0],
    ['with nothing in it', () => '', -61_000],
  ])('is broken by the next save, and opens before: %s', async (_name, owner, ageMs) => {
    const window = openWindow(startHost(), 'a');
    await mkdir(join(project, '.scrim'));
    const lock = join(project, '.scrim', 'lock');
    await writeFile(lock, owner());
    const date = new Date(Date.now() + ageMs);
    await utimes(lock, date, date);
    const { handle, files, revision } = await window.call('project.open', { path: project });
    await writeFile(lock, owner());
    await utimes(lock, date, date);
    await window.call('project.save', { handle, files: retitled(files, 'Two'), revision, overwrite: false });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Two"}\n');
    expect((await readdir(join(project, '.scrim'))).filter((name) => /^(?:lock|save|temp)/.test(name))).toEqual([]);
  });

  test('and broken while a save is under way: that save writes nothing, and leaves the lock to its new holder', async () => {
    const lock = join(project, '.scrim', 'lock');
    const breaking: FileLayer = {
      ...NODE_FILES,
      writeNew: async (path, bytes) => {
        await NODE_FILES.writeNew(path, bytes);
        if (/save-[0-9a-f]+.journal/.test(path)) await writeFile(lock, elsewhere);
      },
    };
    const window = openWindow(startHost(breaking), 'a');
    const { handle, files, revision } = await window.call('project.open', { path: project });
    const save = window.call('project.save', { handle, files: retitled(files, 'Two'), revision, overwrite: false });
    await expect(save).rejects.toMatchObject({ diagnostic: { code: 'SCR066' } });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"First"}\n');
    expect(await readFile(lock, 'utf8')).toBe(elsewhere);
    // The watcher of the window writes a file for a moment, to date the lock.
    await eventually(async () =>
      expect((await readdir(join(project, '.scrim'))).filter((name) => /^(?:save|temp)/.test(name))).toEqual([]),
    );
  });
});

test('saving over a folder removes nothing that somebody else added, and keeps what it replaced', async () => {
  await writeFile(join(project, 'shaders', 'mine.fs'), 'mine');
  const window = openWindow(startHost(), 'a');
  const { handle, files, revision } = await window.call('project.open', { path: project });
  await writeFile(join(project, 'shaders', 'theirs.fs'), 'theirs');
  await writeFile(join(project, 'project.scrim.json'), '{"title":"Theirs"}\n');
  const next = { ...retitled(files, 'Mine'), sources: {} };
  const saved = await window.call('project.save', { handle, files: next, revision, overwrite: true });
  expect(await readdir(join(project, 'shaders'))).toEqual(['theirs.fs']);
  expect(saved.kept).toMatch(/^\.scrim\/replaced-/);
  const kept = join(project, saved.kept ?? '');
  expect(await readFile(join(kept, 'project.scrim.json'), 'utf8')).toBe('{"title":"Theirs"}\n');
  expect(await readFile(join(kept, 'shaders', 'mine.fs'), 'utf8')).toBe('mine');
  // The next save, which nobody has asked to write over anything, leaves it alone as well.
  await window.call('project.save', { handle, files: retitled(next, 'Again'), revision: saved.revision, overwrite: false });
  expect(await readdir(join(project, 'shaders'))).toEqual(['theirs.fs']);
});

test('a project folder that is gone is reported as missing, and not created again', async () => {
  const window = openWindow(startHost(), 'a');
  const { handle, files, revision } = await window.call('project.open', { path: project });
  await rm(project, { recursive: true });
  const gone = { diagnostic: { code: 'SCR067', message: expect.stringContaining(`${project} is missing`) } };
  for (const overwrite of [false, true]) {
    await expect(window.call('project.save', { handle, files, revision, overwrite })).rejects.toMatchObject(gone);
  }
  await expect(window.call('project.autosave', { handle, files })).rejects.toMatchObject(gone);
  expect(await readdir(base)).toEqual([]);
  await window.call('project.save-as', { handle, path: join(base, 'again'), files });
  expect(await readFile(join(base, 'again', 'project.scrim.json'), 'utf8')).toBe(files.project);
});

describe('changes from outside', () => {
  /** How other programs write: over the file, by a rename, by taking it away and putting it back. */
  const WAYS: readonly (readonly [string, (path: string) => Promise<unknown>])[] = [
    ['over the file', (path) => writeFile(path, CHANGED)],
    [
      'by a rename',
      async (path) => {
        await writeFile(`${path}.tmp`, CHANGED);
        await rename(`${path}.tmp`, path);
      },
    ],
    [
      'by taking it away first',
      async (path) => {
        await rm(path);
        await writeFile(path, CHANGED);
      },
    ],
    [
      'by emptying it first, on a slow machine',
      async (path) => {
        await writeFile(path, '');
        // Longer than changes are gathered, and far shorter than an empty file is looked at.
        await new Promise((done) => setTimeout(done, 400));
        await writeFile(path, CHANGED);
      },
    ],
  ];
  const CHANGED = '{"title":"Changed"}\n';

  test.each(WAYS)('are noticed once: %s', async (_name, write) => {
    const host = startHost();
    const events: HostEvent[] = [];
    host.subscribe((event) => events.push(event));
    const window = openWindow(host, 'a');
    const { handle } = await window.call('project.open', { path: project });
    const heard = nextEvent(host);
    await write(join(project, 'project.scrim.json'));
    expect(await heard).toMatchObject({ kind: 'project-changed-outside', handle });
    const again = await window.call('project.open', { path: project });
    expect(again.files.project).toBe(CHANGED);
    expect(events).toEqual([{ kind: 'project-changed-outside', handle, revision: again.revision }]);
  });

  test('of shaders are noticed, too, in a folder that was not there before', async () => {
    await rm(join(project, 'shaders'), { recursive: true });
    const host = startHost();
    const { handle } = await openWindow(host, 'a').call('project.open', { path: project });
    const heard = nextEvent(host);
    await mkdir(join(project, 'shaders'));
    await writeFile(join(project, 'shaders', 'new.fs'), 'void main() {}\n');
    expect(await heard).toMatchObject({
      kind: 'shaders-changed-outside',
      handle,
      shaders: [{ file: 'new.fs', before: null, text: 'void main() {}\n' }],
    });
  });

  test('of chunks are noticed, and of those in folders of theirs that are new', async () => {
    const host = startHost();
    const { handle } = await openWindow(host, 'a').call('project.open', { path: project });
    const folder = join(project, 'shaders', 'chunks');
    const said = async (write: () => Promise<void>) => {
      const heard = nextEvent(host);
      await write();
      return heard;
    };
    await mkdir(join(folder, 'ink'), { recursive: true });
    const file = 'chunks/ink/dots.glsl';
    expect(await said(() => writeFile(join(folder, 'ink', 'dots.glsl'), 'float a;\n'))).toMatchObject({
      kind: 'shaders-changed-outside',
      handle,
      shaders: [{ file, before: null, text: 'float a;\n' }],
    });
    expect(await said(() => writeFile(join(folder, 'ink', 'dots.glsl'), 'float b;\n'))).toMatchObject({
      shaders: [{ file, before: 'float a;\n', text: 'float b;\n' }],
    });
  });
});

describe('a disk that fails', () => {
  const failing = (code: string): FileLayer => ({
    ...NODE_FILES,
    writeNew: async (path, bytes) => {
      if (path.includes('/save-')) {
        await NODE_FILES.writeNew(path, bytes.subarray(0, bytes.length / 2));
        throw Object.assign(new Error(code), { code });
      }
      return NODE_FILES.writeNew(path, bytes);
    },
  });

  test.each([
    ['full', 'ENOSPC', 'SCR062'],
    ['over its quota', 'EDQUOT', 'SCR062'],
    ['read-only', 'EROFS', 'SCR060'],
  ])('leaves the old files whole, and can be saved to again: %s', async (_name, errno, code) => {
    const broken = openWindow(startHost(failing(errno)), 'a');
    const { handle, files, revision } = await broken.call('project.open', { path: project });
    const next = { ...retitled(files, 'Second'), layout: '{}\n', sources: { 'edge.fs': 'void main() {}\n' } };
    const save = broken.call('project.save', { handle, files: next, revision, overwrite: false });
    await expect(save).rejects.toMatchObject({ diagnostic: { code } });
    expect((await openWindow(startHost(), 'b').call('project.open', { path: project })).files).toEqual(files);
    const left = (await readdir(join(project, '.scrim'))).filter((name) => /^(?:lock|save|temp)/.test(name));
    expect(left).toEqual([]);
    const whole = openWindow(startHost(), 'c');
    const opened = await whole.call('project.open', { path: project });
    await whole.call('project.save', { handle: opened.handle, files: next, revision, overwrite: false });
    expect((await whole.call('project.open', { path: project })).files).toEqual(next);
  });

  test('a project that may only be read opens all the same', async () => {
    if (process.getuid?.() === 0) {
      // Root may write anywhere; what stands in the way of Scrim's folder is a file of that name.
      await writeFile(join(project, '.scrim'), 'a file');
    } else await chmod(project, 0o500);
    const window = openWindow(startHost(), 'a');
    const { handle, files, revision } = await window.call('project.open', { path: project });
    expect(files.project).toBe('{"title":"First"}\n');
    const save = window.call('project.save', { handle, files: retitled(files, 'Second'), revision, overwrite: false });
    await expect(save).rejects.toMatchObject({ diagnostic: { code: 'SCR060' } });
    await chmod(project, 0o700);
  });
});

function nextEvent(host: HostService): Promise<HostEvent> {
  return new Promise((done) => {
    const stop = host.subscribe((event) => {
      stop();
      done(event);
    });
  });
}
