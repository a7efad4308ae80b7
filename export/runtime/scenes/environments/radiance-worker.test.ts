import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { text } from '../../../../nodes/generated/workers/decode-radiance.gen.ts';
import { writeExr } from '../../../../tests/support/write-exr.ts';
import { writeHdr } from '../../../../tools/examples/write-hdr.ts';
import type { StartWorker } from '../../cpu/worker-source.ts';
import { readRadianceHeader } from './radiance-header.ts';
import type { RadianceScope } from './radiance-worker.ts';
import { readRadiance } from './read-radiance.ts';
import { readRadianceInWorker } from './read-radiance-in-worker.ts';

/** Runs the text of the worker, which has its own copies of the loaders, here. */
function textRunner() {
  const log: string[] = [];
  const start: StartWorker = (script, { onMessage }) => {
    const scope: RadianceScope = { onmessage: null, postMessage: (answer) => onMessage(answer) };
    new Function('self', script)(scope);
    log.push('start');
    return {
      post: (data) => void Promise.resolve().then(() => scope.onmessage?.({ data } as never)),
      dispose: () => log.push('end'),
    };
  };
  return { log, start };
}

/** Radiance from 0 to 60. */
const RGB = Array.from({ length: 64 * 32 * 3 }, (_, i) => (i % 41) * 1.5);
const header = (bytes: ArrayBuffer) => readRadianceHeader(bytes) as NonNullable<ReturnType<typeof readRadianceHeader>>;

test.each([
  ['HDR', writeHdr(64, 32, RGB).buffer],
  ['EXR', writeExr(64, 32, RGB).buffer],
])('a worker decodes %s to the numbers that three’s loaders give in the page, and ends', async (_format, bytes) => {
  const { log, start } = textRunner();
  const apart = readRadianceInWorker(text, start);
  for (const as of ['halves', 'floats'] as const) {
    const pixels = await apart[as](bytes, header(bytes));
    expect(pixels).toEqual(readRadiance[as](bytes, header(bytes)));
    expect([pixels.widthPx, pixels.heightPx]).toEqual([64, 32]);
  }
  expect(log).toEqual(['start', 'end', 'start', 'end']);
});

test('a damaged file is refused with the message that it has in the page', async () => {
  const { log, start } = textRunner();
  const whole = await readFile(join(resolve(import.meta.dirname, '../../../..'), 'nodes/source/panorama/example/assets/sky.hdr'));
  const bytes = whole.buffer.slice(whole.byteOffset, whole.byteOffset + 400) as ArrayBuffer;
  await expect(readRadianceInWorker(text, start).halves(bytes, header(bytes))).rejects.toThrow(
    'the file is incomplete. Copy or export it again',
  );
  expect(log).toEqual(['start', 'end']);
});

test('where the worker fails, the panorama is refused with what to do', async () => {
  const start: StartWorker = (_text, { onFailure }) => ({ post: () => onFailure('out of memory'), dispose: () => {} });
  const bytes = writeHdr(64, 32, RGB).buffer;
  await expect(readRadianceInWorker(text, start).halves(bytes, header(bytes))).rejects.toThrow(
    'its decoder failed: out of memory. Reload the page, or use a smaller panorama',
  );
});
