import { describe, expect, test } from '@jest/globals';
import { DEFINITIONS, SHADERS } from '../../../nodes/generated/definitions.gen.ts';
import { createLibraries, hasSameTypes } from './library.ts';

const HEADER = '/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }, { "NAME": "amount", "TYPE": "float" }] }*/';
const DARK = `${HEADER}\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * 0.5; }`;

describe('the library of a project whose shader is being typed', () => {
  const libraries = createLibraries({ definitions: DEFINITIONS, shaders: SHADERS });
  const inside = {
    nodes: { 'mine-aaaa': { type: 'filter/mine', version: 1, params: {} } },
    exposed: { inputs: [{ name: 'inputImage', node: 'mine-aaaa', port: 'inputImage' }], outputs: [] },
    wires: [],
  };
  const withText = (text: string) =>
    libraries.of({ sources: { 'mine.fs': text }, graphs: { main: { nodes: {}, wires: [] }, look: inside } } as never);
  const dark = withText(DARK);

  test('has the same node types while the header says the same, with the new text', () => {
    for (const text of [DARK.replace('0.5', '0.25'), `${HEADER}\nvoid main() {`]) {
      const typed = withText(text);
      expect(hasSameTypes(dark, typed)).toBe(true);
      expect(typed.definition('filter/mine')).toBe(dark.definition('filter/mine'));
      expect(typed.shader('shaders/mine.fs')).toBe(text);
    }
  });

  test('has other node types where an input is renamed, or a file is added', () => {
    const renamed = withText(DARK.replace('amount', 'strength'));
    expect(hasSameTypes(dark, renamed)).toBe(false);
    expect(Object.keys(renamed.definition('filter/mine')?.params ?? {})).toEqual(['strength']);
    const added = libraries.of({ sources: { 'mine.fs': DARK, 'other.fs': DARK }, graphs: {} });
    expect(hasSameTypes(dark, added)).toBe(false);
  });
});
