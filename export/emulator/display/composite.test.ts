import { expect, test } from '@jest/globals';
import { compositePixels, turnRows } from './composite.ts';

const ROOM = { widthPx: 2, heightPx: 1, rgba: new Uint8Array([200, 100, 50, 255, 10, 20, 30, 255]) };
const LAYER = { widthPx: 2, heightPx: 1, rgba: new Uint8Array([64, 0, 0, 128, 0, 0, 0, 0]) };

test('a layer over the room', () => {
  // 64 + 200 · 127 / 255 = 163.6
  expect([...compositePixels(LAYER, ROOM, 'alpha-blend').rgba]).toEqual([164, 50, 25, 255, 10, 20, 30, 255]);
});

test('a layer adds its light to the room, up to white', () => {
  // Red in linear light: 0.5776 + 2 × 0.0513 = 0.6802, which is 215 of 255.
  expect([...compositePixels(LAYER, ROOM, 'additive').rgba]).toEqual([215, 100, 50, 255, 10, 20, 30, 255]);
  expect(compositePixels(LAYER, ROOM, 'additive', 1).rgba[0]).toBe(208);
  expect(compositePixels(LAYER, ROOM, 'additive', 100).rgba[0]).toBe(255);
});

test('a layer alone', () => {
  expect([...compositePixels(LAYER, ROOM, 'opaque').rgba]).toEqual([64, 0, 0, 255, 0, 0, 0, 255]);
});

test('rows turned over', () => {
  expect([...turnRows(new Uint8Array([1, 1, 1, 1, 2, 2, 2, 2]), 1, 2).rgba]).toEqual([2, 2, 2, 2, 1, 1, 1, 1]);
});
