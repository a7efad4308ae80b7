import { expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import type { FrameRenderAnswer } from '../editor/editor.ts';
import { cancelExport } from '../files/export-page.ts';
import { rephotographCapture } from './rephotograph-capture.ts';

const CHOICE = { path: 'assets/room.capture/capture.json', method: null, blended: 3 };
const PIXEL = { widthPx: 1, heightPx: 1 };
const SHOT = { method: 'lumigraph', psnrDb: Infinity, ssim: Number.NaN, chromaError: 0, covered: 1, ...PIXEL } as const;

/** A page that draws one pixel. `answer` may replace what it says. */
async function withPage(answer: (asked: string) => FrameRenderAnswer | null = () => null) {
  const opened = await openTestEditor();
  const { editor, host } = opened;
  const asked: string[] = [];
  let closed = false;
  editor.renderPage.open = () => ({
    ask: async (message) => {
      asked.push(message.kind === 'rephotograph' ? `${message.method} ${message.index}` : message.kind);
      const shot = { ...SHOT, shown: Uint8Array.of(1, 2, 3, 255), error: Uint8ClampedArray.of(4, 5, 6, 255) };
      return answer(asked.at(-1) ?? '') ?? { kind: 'rephotographed', shot: message.kind === 'rephotograph' ? shot : null };
    },
    close: () => {
      closed = true;
    },
  });
  const methods = () => host.calls.flatMap(({ method }) => (method.startsWith('rephotograph.') ? method : []));
  return { ...opened, asked, methods, isClosed: () => closed };
}

test('each photograph is drawn by each method, and the means are shown at the end', async () => {
  const { editor, host, asked, methods, isClosed } = await withPage();
  host.answer('rephotograph.begin', () => ({ methods: ['plain', 'lumigraph'], views: 2 }));
  expect(await rephotographCapture(editor, CHOICE)).toBe(true);
  expect(asked).toEqual(['rephotograph-begin', 'plain 0', 'lumigraph 0', 'plain 1', 'lumigraph 1']);
  const add = 'rephotograph.add';
  expect(methods()).toEqual(['rephotograph.begin', add, add, add, add, 'rephotograph.finish']);
  expect(host.calls.find(({ method }) => method === add)?.input).toMatchObject({
    ...{ index: 0, method: 'plain', size: PIXEL, psnrDb: null, ssim: null, chromaError: 0 },
    picture: Uint8Array.of(1, 2, 3, 255),
    error: Uint8Array.of(4, 5, 6, 255),
  });
  const { dialog, exporting } = editor.ui.getState();
  expect(dialog).toMatchObject({ kind: 'rephotographed', rephotographed: { views: 2, means: [{ psnrDb: 30.5 }] } });
  expect([exporting, isClosed()]).toEqual([null, true]);
});

test('canceled between two photographs, it leaves no report', async () => {
  const page = await withPage((asked) => {
    if (asked === 'lumigraph 1') void cancelExport(page.editor);
    return null;
  });
  expect(await rephotographCapture(page.editor, CHOICE)).toBe(false);
  expect(page.methods().slice(-1)).toEqual(['rephotograph.cancel']);
  expect(page.editor.ui.getState()).toMatchObject({ exporting: null, dialog: null, toasts: [{ text: 'Rephotography canceled.' }] });
});

test('a page that cannot load the capture says why', async () => {
  const message = 'The capture cannot be rephotographed: a file is missing.';
  const { editor, methods, isClosed } = await withPage(() => ({
    kind: 'render-failed',
    diagnostic: { code: 'SCR032', severity: 'error', message },
  }));
  expect(await rephotographCapture(editor, CHOICE)).toBe(false);
  expect([methods().at(-1), isClosed(), editor.ui.getState().toasts.map(({ text }) => text)]).toEqual([
    'rephotograph.cancel',
    true,
    [message],
  ]);
});
