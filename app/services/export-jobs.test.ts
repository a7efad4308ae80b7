import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { POSTER_SIZE } from '../../export/bundle/poster.ts';
import { openWindow, startHost, stopHosts } from '../../tests/support/host-kit.ts';
import { projectText } from '../../tests/support/project-kit.ts';
import type { HostEvent } from '../contract/contract.ts';
import { POSTER_SIZE as CONTRACT_SIZE } from '../contract/poster-size.ts';
import type { HostService } from './host.ts';

/** As much of a JPEG as the host looks at. */
const JPEG = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 1, 2, 3);

let base = '';
let project = '';
let out = '';
let host: HostService;
let told: HostEvent[] = [];
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-exports-'));
  project = join(base, 'project');
  out = join(base, 'page');
  await mkdir(project);
  const text = projectText({
    nodes: { 'video-a1b2': 'source/camera-video', 'sepia-a1b2': 'filter/sepia', 'screen-a1b2': 'output/screen' },
    wires: ['video-a1b2.layer -> sepia-a1b2.inputImage', 'sepia-a1b2.layer -> screen-a1b2.layer'],
  });
  await writeFile(join(project, 'project.scrim.json'), text);
  host = startHost();
  told = [];
  host.subscribe((event) => told.push(event));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

async function open(name = 'a') {
  const window = openWindow(host, name);
  const { handle, files } = await window.call('project.open', { path: project });
  return { window, handle, files };
}

describe('an export by the host', () => {
  test('has the picture that it was given, and tells what it is at', async () => {
    const { window, handle, files } = await open();
    expect(await window.call('export.run', { handle, files, out, poster: JPEG })).toMatchObject({ ok: true, diagnostics: [] });
    const name = (await readdir(out)).find((file) => file.startsWith('poster-')) ?? '';
    expect(name).toMatch(/\.jpg$/);
    expect([...(await readFile(join(out, name)))]).toEqual([...JPEG]);
    expect(await readFile(join(out, 'index.html'), 'utf8')).toContain(`<img class="poster" src="${name}"`);
    expect(CONTRACT_SIZE).toEqual(POSTER_SIZE);
    const steps = told.flatMap((event) => (event.kind === 'export-progress' && event.handle === handle ? [event.text] : []));
    expect(steps.slice(0, 3)).toEqual(['Compiling…', 'Bundling the page…', 'Writing file 1…']);
  });

  test('has the picture that the project keeps, and the given one while its file is missing', async () => {
    const { window, handle, files } = await open();
    const { path } = await window.call('asset.import', {
      handle,
      name: 'poster.png',
      bytes: Uint8Array.from(encode({ width: 40, height: 21, data: new Uint8Array(40 * 21 * 3), channels: 3 })),
    });
    const keeping = (poster: string) => ({
      ...files,
      project: files.project.replace('"graphs"', `"page": { "poster": "${poster}" }, "graphs"`),
    });
    const posters = async () => (await readdir(out)).filter((file) => file.startsWith('poster-'));
    expect(await window.call('export.run', { handle, files: keeping(path), out, poster: JPEG })).toMatchObject({ ok: true });
    const [kept = ''] = await posters();
    expect(kept).toMatch(/\.png$/);
    expect(await readFile(join(out, kept))).toEqual(await readFile(join(project, path)));
    for (const other of ['assets/none.jpg', 'project.scrim.json', '../secret.jpg']) {
      expect(await window.call('export.run', { handle, files: keeping(other), out, poster: JPEG })).toMatchObject({ ok: true });
      expect(await posters()).toEqual([expect.stringMatching(/\.jpg$/)]);
    }
  });

  test('reports its sizes and devices, and is shown on this machine until the host ends', async () => {
    const { window, handle, files } = await open();
    await expect(window.call('export.show', { handle, open: true })).rejects.toMatchObject({ diagnostic: { code: 'SCR004' } });
    const { report } = await window.call('export.run', { handle, files, out, poster: JPEG, address: 'https://example.org/effect' });
    expect(report?.parts.map(({ kind }) => kind)).toEqual(
      expect.arrayContaining(['page', 'script', 'style', 'program', 'poster', 'offline']),
    );
    expect(report?.bytes.gzip).toBe(report?.parts.reduce((sum, { gzip }) => sum + gzip, 0));
    expect(report?.devices.find(({ title }) => title.startsWith('Android phone'))?.tier).toBe('ar-camera');
    const { url, opened } = await window.call('export.show', { handle, open: true });
    expect(opened).toBe(false);
    const page = await fetch(url);
    expect([page.status, page.headers.get('content-type')]).toEqual([200, 'text/html; charset=utf-8']);
    expect(await page.text()).toContain('https://example.org/effect/poster-');
    await window.call('export.run', { handle, files, out, poster: JPEG, singleFile: true });
    expect(await window.call('export.show', { handle, open: false })).toEqual({ url, opened: false });
    expect((await readdir(out)).sort()).toEqual(['index.html', 'report.json']);
    await stopHosts();
    await expect(fetch(url)).rejects.toThrow();
  });

  test('is done without one, too, and says so', async () => {
    const { window, handle, files } = await open();
    const { ok, diagnostics } = await window.call('export.run', { handle, files, out, poster: null });
    expect(ok).toBe(true);
    expect(diagnostics).toEqual([expect.objectContaining({ code: 'SCR065', severity: 'warning' })]);
    expect((await readdir(out)).filter((file) => file.startsWith('poster-'))).toEqual([expect.stringMatching(/\.png$/)]);
  });

  test('takes nothing for a picture that is none', async () => {
    const { window, handle, files } = await open();
    for (const poster of [
      new TextEncoder().encode('<svg onload="alert(1)">'),
      Object.assign(new Uint8Array(8 * 2 ** 20 + 1), JPEG),
      new Uint8Array(),
    ]) {
      await expect(window.call('export.run', { handle, files, out, poster })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    }
    expect(await readdir(base)).toEqual(['project']);
  });

  test.each(['Compiling…', 'Bundling the page…', 'Writing file 2…'])('is cancelled at any step, and leaves nothing: %s', async (step) => {
    const { window, handle, files } = await open();
    const cancelled: Promise<unknown>[] = [];
    host.subscribe((event) => {
      if (event.kind === 'export-progress' && event.text === step) cancelled.push(window.call('export.cancel', { handle }));
    });
    const result = await window.call('export.run', { handle, files, out, poster: JPEG });
    expect(result).toEqual({ ok: false, out, diagnostics: [], report: null });
    expect(cancelled).toHaveLength(1);
    expect(await readdir(base)).toEqual(['project']);
  });

  test('that is cancelled leaves the page that was there, and another window’s export alone', async () => {
    const first = await open('a');
    const second = await open('b');
    await first.window.call('export.run', { handle: first.handle, files: first.files, out, poster: JPEG });
    const before = (await readdir(out)).sort();
    host.subscribe((event) => {
      if (event.kind === 'export-progress') void first.window.call('export.cancel', { handle: first.handle });
    });
    const there = join(base, 'there');
    const [mine, theirs] = await Promise.all([
      first.window.call('export.run', { handle: first.handle, files: first.files, out, poster: null }),
      second.window.call('export.run', { handle: second.handle, files: second.files, out: there, poster: JPEG }),
    ]);
    expect([mine.ok, theirs.ok]).toEqual([false, true]);
    expect((await readdir(out)).sort()).toEqual(before);
    expect((await readdir(base)).sort()).toEqual(['page', 'project', 'there']);
  });
});
