import { expect, test } from '@jest/globals';
import { LIBRARY } from '../../../tests/support/library.ts';
import { hasPaletteImage, paletteImageOf } from './palette-images.ts';

test('each filter that needs nothing but a layer has an image; other nodes have none', () => {
  const definitions = [...LIBRARY.types()].flatMap((type) => LIBRARY.definition(type) ?? []);
  const shown = definitions.filter(({ type }) => paletteImageOf(type) !== null).map(({ type }) => type);
  expect(shown.sort()).toEqual(
    definitions
      .filter(hasPaletteImage)
      .map(({ type }) => type)
      .sort(),
  );
  expect(shown.length).toBeGreaterThan(35);
  const places = shown.map((type) => paletteImageOf(type)?.position);
  expect(new Set(places).size).toBe(shown.length);
});
