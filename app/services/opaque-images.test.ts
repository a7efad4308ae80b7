import { mkdtemp, rm, writeFile } from 'node:fs/promises';
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
