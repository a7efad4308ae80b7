import { copyFile, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import sharp, { type Sharp } from 'sharp';
import { findOpaqueImages } from './opaque-images.ts';

let root: string;
beforeAll(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-opaque-'));
});
afterAll(() => rm(root, { recursive: true, force: true }));

/** An image of another encoder; its palette, if any, is transparent where the color is. */
async function write(path: string, channels: 3 | 4, encode: (image: Sharp) => Sharp): Promise<void> {
  const alpha = channels === 4 ? { alpha: 0.5 } : {};
  const image = sharp({ create: { width: 8, height: 8, channels, background: { r: 200, g: 100, b: 50, ...alpha } } });
  await writeFile(join(root, path), await encode(image).toBuffer());
}

test('images without transparency are found, whatever their files are called', async () => {
  await write('photo.jpg', 3, (image) => image.jpeg());
  await write('plain.png', 3, (image) => image.png());
  await write('gray.png', 3, (image) => image.grayscale().png());
  await write('palette.png', 3, (image) => image.png({ palette: true }));
  await write('alpha.png', 4, (image) => image.png());
  await write('clear-palette.png', 4, (image) => image.png({ palette: true }));
  await write('photo.webp', 3, (image) => image.webp());
  await write('clear.webp', 4, (image) => image.webp());
  await writeFile(join(root, 'all-ones.png'), await sharp(join(root, 'plain.png')).ensureAlpha(1).png().toBuffer());
  await writeFile(join(root, 'deep.png'), await sharp(join(root, 'plain.png')).ensureAlpha(1).toColorspace('rgb16').png().toBuffer());
  // A PNG file by another name.
  await write('wrong.jpg', 4, (image) => image.png());
  await writeFile(join(root, 'cut.png'), Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'));
  const paths = [
    'photo.jpg',
    'plain.png',
    'gray.png',
    'palette.png',
    'alpha.png',
    'clear-palette.png',
    'all-ones.png',
    'deep.png',
    'clear.webp',
    'photo.webp',
    'wrong.jpg',
    'cut.png',
  ];
  const assets = Object.fromEntries([...paths, 'missing.png', '../outside.png'].map((path) => [path, { path, kind: 'image' as const }]));
  expect(await findOpaqueImages(root, { ...assets, model: { path: 'photo.jpg', kind: 'model' } })).toEqual([
    'photo.jpg',
    'plain.png',
    'gray.png',
    'palette.png',
    'all-ones.png',
    'deep.png',
    'photo.webp',
  ]);
});

test('files whose headers say less than their pixels count as transparent', async () => {
  const opaque = await sharp({ create: { width: 8, height: 8, channels: 3, background: 'red' } })
    .webp()
    .toBuffer();
  const chunk = (type: string, content: Uint8Array) => {
    const head = Buffer.alloc(8);
    head.write(type, 'latin1');
    head.writeUInt32LE(content.length, 4);
    return Buffer.concat([head, content, Buffer.alloc(content.length % 2)]);
  };
  const webp = (flags: number, ...chunks: readonly Uint8Array[]) => {
    const content = Buffer.concat([chunk('VP8X', Buffer.from([flags, 0, 0, 0, 7, 0, 0, 7, 0, 0])), ...chunks]);
    return chunk('RIFF', Buffer.concat([Buffer.from('WEBP'), content]));
  };
  const picture = opaque.subarray(12);
  const deep = await sharp(
    Uint16Array.from({ length: 64 * 4 }, (_, i) => (i === 63 * 4 + 3 ? 65_534 : 65_535)),
    {
      raw: { width: 8, height: 8, channels: 4 },
    },
  )
    .toColorspace('rgb16')
    .png()
    .toBuffer();
  const png = await sharp({ create: { width: 8, height: 8, channels: 3, background: 'red' } })
    .png()
    .toBuffer();
  const iphone = Buffer.concat([
    png.subarray(0, 8),
    Buffer.from('\0\0\0\x04CgBI\x50\0\x20\x02\x2b\xd5\xb3\x7f', 'latin1'),
    png.subarray(8),
  ]);
  const clear = sharp({ create: { width: 8, height: 8, channels: 4, background: { r: 255, g: 0, b: 0, alpha: 0.5 } } });
  const files: Readonly<Record<string, Uint8Array>> = {
    'plain.webp': webp(0, picture),
    'with-profile.webp': webp(0x20, chunk('ICCP', Buffer.alloc(3)), picture),
    'announced.webp': webp(0x10, picture),
    'unannounced.webp': webp(0, chunk('ALPH', Buffer.alloc(5)), picture),
    'lossless.webp': webp(0, chunk('VP8L', Buffer.alloc(9))),
    'animated.webp': webp(0x02, chunk('ANIM', Buffer.alloc(6)), chunk('ANMF', Buffer.concat([Buffer.alloc(16), picture]))),
    'cut.webp': webp(0, picture).subarray(0, 32),
    'cut-flags.webp': webp(0, picture).subarray(0, 20),
    'almost.png': deep,
    'iphone.png': iphone,
    'cut-color.png': png.subarray(0, 25),
    'cut-chunks.png': png.subarray(0, 34),
    'clear.gif': await clear.clone().gif().toBuffer(),
    'clear.avif': await clear.clone().avif({ effort: 0 }).toBuffer(),
    'nothing.png': new Uint8Array(),
  };
  for (const [name, bytes] of Object.entries(files)) await writeFile(join(root, name), bytes);
  const assets = Object.fromEntries(Object.keys(files).map((path) => [path, { path, kind: 'image' as const }]));
  expect(await findOpaqueImages(root, assets)).toEqual(['plain.webp', 'with-profile.webp']);
});

test('videos without alpha channel are found by their tracks', async () => {
  const box = (type: string, ...content: readonly Buffer[]) => {
    const head = Buffer.alloc(8);
    head.writeUInt32BE(8 + content.reduce((sum, { length }) => sum + length, 0));
    head.write(type, 4, 'latin1');
    return Buffer.concat([head, ...content]);
  };
  const mp4 = (entry: string) =>
    Buffer.concat([box('ftyp', Buffer.from('isom')), box('mdat', Buffer.alloc(100_000)), box('moov', box('stsd', box(entry)))]);
  const webm = (tracks: readonly number[]) => Buffer.from([0x1a, 0x45, 0xdf, 0xa3, 0x80, 0x16, 0x54, 0xae, 0x6b, ...tracks]);
  const files: Readonly<Record<string, Buffer>> = {
    'h264.mp4': mp4('avc1'),
    'hevc.mp4': mp4('hvc1'),
    'cut.mp4': mp4('avc1').subarray(0, 50_000),
    'endless.mp4': Buffer.concat([box('ftyp'), Buffer.alloc(100)]),
    'plain.webm': webm([]),
    'alpha.webm': webm([0xe0, 0x53, 0xc0, 0x81, 0x01]),
    'no-tracks.webm': webm([]).subarray(0, 5),
  };
  for (const [name, bytes] of Object.entries(files)) await writeFile(join(root, name), bytes);
  // Files of a real encoder: the film has an alpha channel.
  await copyFile('nodes/source/video-file/example/assets/film.webm', join(root, 'film.webm'));
  await copyFile('examples/boards/gallery/assets/stripes.webm', join(root, 'stripes.webm'));
  const assets = Object.fromEntries(
    [...Object.keys(files), 'film.webm', 'stripes.webm'].map((path) => [path, { path, kind: 'video' as const }]),
  );
  expect(await findOpaqueImages(root, assets)).toEqual(['h264.mp4', 'plain.webm', 'stripes.webm']);
});
