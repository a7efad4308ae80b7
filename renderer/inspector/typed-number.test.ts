import { describe, expect, test } from '@jest/globals';
import { parseTyped } from './typed-number.ts';

describe('a number field takes', () => {
  test.each([
    ['12', 'none', 12],
    ['0,5 m', 'm', 0.5],
    ['1/4', 'none', 0.25],
    ['=2 * (3 + 1)', 'px', 8],
    ['= 1.5', 'none', 1.5],
    ['180 / 2', 'rad', Math.PI / 2],
    ['sqrt(2) ^ 2', 'm', 2],
    ['20cm', 'm', 0.2],
    ['1 m + 20 cm', 'm', 1.2],
    ['3 ft / 2', 'm', 0.4572],
    ['250 ms', 's', 0.25],
    ['0.25 turn', 'rad', Math.PI / 2],
    ['90 deg + 90', 'rad', Math.PI],
    ['max(1cm, 2cm)', 'm', 0.02],
    ['1.2 kHz', 'Hz', 1200],
    ['50 %', 'none', 0.5],
    ['7 % 4', 'none', 3],
  ] as const)('%s in %s', (text, unit, stored) => {
    expect(parseTyped(text, unit)).toBeCloseTo(stored, 12);
  });

  test.each(['', '=', 'abc', '=sin(time)', 'frame', '1/0', '2 +', '[1, 2]', '2 cm', '3 kg'])('not %j', (text) => {
    expect(parseTyped(text, 'none')).toBeNull();
  });
});
