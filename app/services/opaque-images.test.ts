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
