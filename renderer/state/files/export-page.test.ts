import { describe, expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import { openTestEditor, type TestEditor } from '../../../tests/support/test-editor.ts';
import { undo } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { keepExports } from '../preferences/kept-exports.ts';
import { createPosterRequests } from '../preview-sync/preview-posters.ts';
import { handleHostEvents } from '../start.ts';
import { cancelExport, copyExportAddress, exportPage, openExportDialog, readAddress, visitExport } from './export-page.ts';
import { filesOf, openPath } from './files.ts';
import { followPreview, keepCurrentImage } from './poster.ts';

const JPEG = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0);

function texts({ ui }: Editor): string[] {
  return ui.getState().toasts.map(({ text }) => text);
}

/** What the host was asked to export with. */
function asked({ host }: TestEditor) {
  return host.calls.find(({ method }) => method === 'export.run')?.input;
}

describe('an export from the editor', () => {
  test('takes the picture of the preview along', async () => {
    const opened = await openTestEditor();
    const { editor } = opened;
    editor.posters.take = async ({ widthPx, heightPx }) => (widthPx === 1200 && heightPx === 630 ? JPEG : null);
    expect(await exportPage(editor, { out: '/page' })).toBe(true);
    expect(asked(opened)).toMatchObject({ out: '/page', poster: JPEG });
    expect(texts(editor)).toEqual(['Exported to /page.']);
    expect(editor.ui.getState().exporting).toBeNull();
  });

  test('takes the picture that the project keeps, until it is drawn at each export again', async () => {
    const opened = await openTestEditor();
    const { editor, host } = opened;
    const kept = Uint8Array.of(0xff, 0xd8, 0xff, 0xe1);
    host.answer('asset.import', () => ({ path: 'assets/poster.jpg' }));
    host.answer('asset.read', () => ({ base64: Buffer.from(kept).toString('base64') }));
    host.answer('asset.list', () => ({ assetFiles: [] }));
    editor.posters.take = async () => JPEG;
    await keepCurrentImage(editor);
    expect(host.calls.find(({ method }) => method === 'asset.import')?.input).toMatchObject({ name: 'poster.jpg', bytes: JPEG });
    expect(filesOf(editor).project).toContain('"poster": "assets/poster.jpg"');
    const exported = async () => {
      await exportPage(editor, { out: '/page' });
      return host.calls.filter(({ method }) => method === 'export.run').at(-1)?.input;
    };
    expect(await exported()).toMatchObject({ poster: kept });
    followPreview(editor);
    expect(await exported()).toMatchObject({ poster: JPEG });
    undo(editor);
    expect(await exported()).toMatchObject({ poster: kept });
    // Its file is missing.
    host.refuse('asset.read', 'SCR004', 'There is no such file.');
    expect(await exported()).toMatchObject({ poster: JPEG });
  });

  test('does without one where there is no preview, or it does not answer', async () => {
    const opened = await openTestEditor();
    const { editor, clock } = opened;
    expect(await exportPage(editor, { out: '/page' })).toBe(true);
    expect(asked(opened)).toMatchObject({ poster: null });

    editor.preview.setState({ ready: true });
    const sent: unknown[] = [];
    const pictures = createPosterRequests(editor, (message) => void sent.push(message));
    const taken = pictures.take({ widthPx: 12, heightPx: 6 });
    expect(sent).toEqual([{ kind: 'poster', request: 1, widthPx: 12, heightPx: 6, framing: null, nodes: [] }]);
    clock.pass(60_000);
    expect(await taken).toBeNull();

    // It answers late, when another is waited for.
    const next = pictures.take({ widthPx: 24, heightPx: 12 });
    pictures.deliver(1, new Uint8Array(1));
    pictures.deliver(2, JPEG);
    expect(await next).toBe(JPEG);
  });

  test('shows its result and its errors in its dialog, if that is still open', async () => {
    const { editor, host } = await openTestEditor();
    openExportDialog(editor);
    host.refuse('export.run', 'SCR061', '/page is not empty.');
    expect(await exportPage(editor, { out: '/page' })).toBe(false);
    expect(editor.ui.getState()).toMatchObject({
      dialog: { kind: 'export' },
      exportErrors: [{ message: '/page is not empty.' }],
      bottom: null,
    });
    expect(texts(editor)).toEqual([]);

    expect(await exportPage(editor, { out: '/page' })).toBe(true);
    expect(editor.ui.getState()).toMatchObject({
      dialog: { kind: 'exported' },
      exportErrors: [],
      exported: { settings: { out: '/page' } },
    });
    const opened: string[] = [];
    await visitExport(editor, (url) => opened.push(url));
    expect(opened).toEqual(['http://127.0.0.1:2/']);
    expect(await copyExportAddress(editor)).toBe('Copied http://127.0.0.1:2/');
    editor.ui.setState(({ exportSettings }) => ({ exportSettings: { ...exportSettings, address: 'example.org/effect' } }));
    expect(await copyExportAddress(editor)).toBe('Copied https://example.org/effect');
    expect(await editor.clipboard.read()).toBe('https://example.org/effect');
  });

  test('is repeated with the settings of its project, which later visits find again', async () => {
    const texts = new Map<string, string>();
    const storage = { getItem: (key: string) => texts.get(key) ?? null, setItem: (key: string, text: string) => void texts.set(key, text) };
    const first = await openTestEditor();
    first.editor.document.setState({ open: null });
    const stop = keepExports(first.editor, storage);
    await openPath(first.editor, '/project');
    await exportPage(first.editor, { out: '/page', singleFile: true, address: 'example.org' });
    expect(asked(first)).toMatchObject({ out: '/page', singleFile: true, offline: true, address: 'https://example.org/' });
    await openPath(first.editor, '/other');
    expect(first.editor.ui.getState().exportSettings).toMatchObject({ out: '', singleFile: false });
    stop();

    const later = await openTestEditor();
    later.editor.document.setState({ open: null });
    keepExports(later.editor, storage);
    await openPath(later.editor, '/project');
    await exportPage(later.editor, { offline: false });
    expect(asked(later)).toMatchObject({ out: '/page', singleFile: true, offline: false, address: 'https://example.org/' });
  });

  test.each([
    ['', null],
    ['example.org/a', 'https://example.org/a'],
    [' http://localhost:8000 ', 'http://localhost:8000/'],
    ['ftp://example.org', null],
    ['javascript:alert(1)', null],
    ['not an address', null],
  ])('of the address %j takes %j', (typed, url) => {
    expect(readAddress(typed)).toBe(url);
  });

  test('is cancelled by another project that is opened, and says no more than that', async () => {
    const opened = await openTestEditor();
    const { editor, host } = opened;
    host.answer('export.run', async ({ out }) => {
      await openPath(editor, '/other');
      return { ok: false, out, diagnostics: [], report: null };
    });
    expect(await exportPage(editor, { out: '/page' })).toBe(false);
    expect(texts(editor)).toEqual(['Export canceled.']);
    expect(editor.ui.getState().bottom).toBeNull();
  });

  test('tells what it is at, of its own project alone, and can be cancelled', async () => {
    const opened = await openTestEditor(newProject('Test'));
    const { host, editor } = opened;
    let finish = () => {};
    const cancelled = new Promise<void>((resolve) => {
      finish = resolve;
    });
    host.answer('export.run', async ({ out }) => {
      await cancelled;
      return { ok: false, out, diagnostics: [], report: null };
    });
    const stop = handleHostEvents(editor);
    const exported = exportPage(editor, { out: '/page' });
    const handle = editor.document.getState().open?.handle ?? '';
    while (asked(opened) === undefined) await Promise.resolve();
    const text = () => editor.ui.getState().exporting?.text;
    host.emit({ kind: 'export-progress', handle, text: 'Compressing assets/robot.glb…' });
    expect(text()).toBe('Compressing assets/robot.glb…');
    host.emit({ kind: 'export-progress', handle: 'another0another0', text: 'Writing…' });
    expect(text()).toBe('Compressing assets/robot.glb…');

    await cancelExport(editor);
    expect(host.calls.at(-1)).toEqual({ method: 'export.cancel', input: { handle } });
    host.emit({ kind: 'export-progress', handle, text: 'Writing file 2…' });
    expect(text()).toBe('Canceling…');
    finish();
    expect(await exported).toBe(false);
    expect(texts(editor)).toEqual(['Export canceled.']);
    stop();
  });

  test('that is cancelled before it reaches the host never does', async () => {
    const opened = await openTestEditor();
    const exported = exportPage(opened.editor, { out: '/page' });
    await cancelExport(opened.editor);
    expect(await exported).toBe(false);
    expect(asked(opened)).toBeUndefined();
  });

  test('is refused with a shader that the driver of the preview refuses', async () => {
    const opened = await openTestEditor();
    const { editor } = opened;
    editor.preview.setState({ shaderDiagnostics: [{ code: 'SCR042', severity: 'error', message: '"glow": undeclared identifier' }] });
    expect(await exportPage(editor, { out: '/page' })).toBe(false);
    expect(asked(opened)).toBeUndefined();
    expect(texts(editor)).toEqual(['"glow": undeclared identifier']);
    expect(editor.ui.getState()).toMatchObject({ bottom: 'problems', exporting: null });
  });
});
