import { type FileHandle, mkdtemp, open, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { imageFileFault } from './check-image-files.ts';

const PHOTO = resolve('nodes/source/capture-mesh/example/assets/glossy-ball.capture/views/003.jpg');
const MIB = 2 ** 20;

let base = '';
let jpeg = Buffer.of();
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-image-files-'));
  jpeg = await readFile(PHOTO);
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** What is wrong with a file of these parts, and how many bytes are read to find it. */
async function check(...parts: readonly Uint8Array[]) {
  const path = join(base, 'image');
  await writeFile(path, Buffer.concat(parts));
  const file = await open(path);
  try {
    let readBytes = 0;
    const counted = {
      read: (bytes: Buffer, offset: number, length: number, at: number) => {
        readBytes += length;
        return file.read(bytes, offset, length, at);
      },
    } as FileHandle;
    return { fault: await imageFileFault(counted, (await file.stat()).size), readBytes };
  } finally {
    await file.close();
  }
}

const filled = (length: number, byte = 0xd9): Buffer => Buffer.alloc(length, byte);
const END = Buffer.of(0xff, 0xd9);

test('a large JPEG file is whole if its image ends, whatever cameras append', async () => {
  const image = jpeg.subarray(0, jpeg.lastIndexOf(END));
  expect(await check(image, filled(3 * MIB), END)).toMatchObject({ fault: null });
  expect(await check(image, filled(3 * MIB))).toMatchObject({ fault: 'is incomplete.' });
  expect(await check(image, filled(3 * MIB), END, filled(2 * MIB + 7))).toMatchObject({ fault: null });
  // The marker is on both sides of a boundary between two parts that are read.
  expect(await check(image, filled(3 * MIB), END, filled(MIB - 1, 0))).toMatchObject({ fault: null });
});

test('a JPEG file with more metadata than is read at first is read whole', async () => {
  // APP segments of the greatest length.
  const segment = Buffer.concat([Buffer.of(0xff, 0xe1, 0xff, 0xff), filled(0xffff - 2, 0)]);
  const metadata = Array.from({ length: 20 }, () => segment);
  expect(await check(jpeg.subarray(0, 2), ...metadata, jpeg.subarray(2))).toMatchObject({ fault: null });
  expect(await check(jpeg.subarray(0, 2), ...metadata, jpeg.subarray(2, -2))).toMatchObject({ fault: 'is incomplete.' });
});

test('a large PNG file is checked without its pixels in memory', async () => {
  const chunk = (type: string, data: Buffer): Buffer => {
    const length = Buffer.alloc(4);
    length.writeUInt32BE(data.length);
    return Buffer.concat([length, Buffer.from(type, 'latin1'), data, Buffer.alloc(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(4000, 0);
  header.writeUInt32BE(3000, 4);
  const png = [Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header), chunk('IDAT', filled(20 * MIB))];
  const whole = await check(...png, chunk('IEND', Buffer.of()));
  expect(whole.fault).toBe(null);
  expect(whole.readBytes).toBeLessThan(2 * MIB);
  expect((await check(...png)).fault).toBe('is incomplete.');
});
