import { describe, expect, test } from '@jest/globals';
import { createValueFormat } from './format.ts';

const plain = (text: string) => text.replaceAll(' ', ' ');

describe('a measured value as text', () => {
  test.each([
    ['auto', 'en-GB', 1.2345, 0.02, 'length', '1.23 m ± 0.02 m'],
    ['auto', 'de-DE', 0.4567, 0.0031, 'length', '45,7 cm ± 0,3 cm'],
    ['auto', 'en-US', 1.2345, 0.02, 'length', '4.05 ft ± 0.07 ft'],
    ['auto', 'en-US', 0.1, 0.002, 'length', '3.94 in ± 0.08 in'],
    ['auto', 'en', 2, 0.3, 'length', '6.6 ft ± 1.0 ft'],
    ['cm', 'en-US', 1.2345, 0.02, 'length', '123 cm ± 2 cm'],
    ['ft', 'en-GB', 1, 0.01, 'area', '10.76 ft² ± 0.11 ft²'],
    ['auto', 'fr-FR', 0.0625, 0.002, 'area', '625 cm² ± 20 cm²'],
    ['m', 'en-GB', 0.03, 0.002, 'volume', '0.030 m³ ± 0.002 m³'],
    ['auto', 'en-GB', Math.PI / 2, 0.013, 'angle', '90.0° ± 0.7°'],
    ['m', 'en-GB', 1, 0, 'length', '1.000 m ± 0.000 m'],
  ] as const)('%s in %s: %d ± %d', (unit, locale, value, uncertainty, dimension, text) => {
    expect(plain(createValueFormat(unit, locale).write(value, uncertainty, dimension))).toBe(text);
  });
});
