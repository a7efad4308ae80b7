import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import process from 'node:process';
import { expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import { icnsOf } from './containers.ts';

const FOLDER = join(process.cwd(), 'app', 'electron', 'icons');

/** Width, height, and whether corners are clear and the middle is not: the icon's square has round corners. */
function look(png: Uint8Array): readonly unknown[] {
  const { width, height, data, channels } = decode(png);
  const alphaAt = (x: number, y: number) => data[(y * width + x) * channels + 3];
  return [width, height, alphaAt(0, 0), alphaAt(width >> 1, height >> 1)];
}

test('Linux has a picture of 512 pixels', async () => {
  expect(look(await readFile(join(FOLDER, 'scrim.png')))).toEqual([512, 512, 0, 255]);
});

test('Windows’ file holds a picture of each size', async () => {
  const ico = await readFile(join(FOLDER, 'scrim.ico'));
  expect([ico.readUInt16LE(0), ico.readUInt16LE(2), ico.readUInt16LE(4)]).toEqual([0, 1, 4]);
  const pictures = [0, 1, 2, 3].map((i) => {
    const at = 6 + 16 * i;
    const [length, offset] = [ico.readUInt32LE(at + 8), ico.readUInt32LE(at + 12)];
    expect(ico.readUInt8(at) || 256).toBe(decode(ico.subarray(offset, offset + length)).width);
    return look(ico.subarray(offset, offset + length)).slice(0, 2);
  });
  expect(pictures).toEqual([16, 32, 48, 256].map((size) => [size, size]));
});

test('Apple’s file holds a picture of each size, and says how long it is', async () => {
  const icns = await readFile(join(FOLDER, 'scrim.icns'));
  expect([icns.toString('latin1', 0, 4), icns.readUInt32BE(4)]).toEqual(['icns', icns.length]);
  const found: unknown[] = [];
  for (let at = 8; at < icns.length; at += icns.readUInt32BE(at + 4)) {
    found.push([icns.toString('latin1', at, at + 4), look(icns.subarray(at + 8, at + icns.readUInt32BE(at + 4)))[0]]);
  }
  expect(found).toEqual([
    ['ic07', 128],
    ['ic08', 256],
    ['ic09', 512],
    ['ic10', 1024],
  ]);
  expect(() => icnsOf([{ sizePx: 100, bytes: new Uint8Array() }])).toThrow('no picture of 100 pixels');
});
