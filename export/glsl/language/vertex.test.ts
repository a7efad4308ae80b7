import { describe, expect, test } from '@jest/globals';
import type { Place } from '../syntax/token.ts';
import { completionsAt } from './complete.ts';
import { hoverAt } from './look-up.ts';
import { renameAt, renameBeside, renameStart } from './rename.ts';
import { readShaderDocument } from './shader-document.ts';
import { applyEdits, placeOf } from './source-text.ts';

const HEADER = `/*{ "ISFVSN": "2", "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" },
  { "NAME": "amount", "TYPE": "float", "DOC": "How much of it." }
], "PASSES": [{ "TARGET": "small", "WIDTH": "$WIDTH * $amount" }, {}] }*/
`;

describe('a vertex shader beside its file', () => {
  const fragment = {
    file: 'shaders/a.fs',
    source: `${HEADER}varying vec2 left;\nvoid main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, left) * amount; }`,
  };
  const vertex =
    'varying vec2 left;\nvoid main() {\n  isf_vertShaderInit();\n  float step = amount / RENDERSIZE.x;\n  left = isf_FragNormCoord - vec2(step, 0.0);\n  gl_Position.x *= amount;\n}';
  const texts = { chunkOf: () => undefined };
  const documents = () => ({
    above: readShaderDocument(fragment.source, fragment.file, texts),
    below: readShaderDocument(vertex, 'shaders/a.vs', { ...texts, fragment }),
  });
  const placeIn = (source: string, text: string) => placeOf(source, source.indexOf(text));

  test('knows the inputs of the header, and what hosts give vertex shaders', () => {
    const { below } = documents();
    const hover = (text: string) => hoverAt(below, placeIn(vertex, text));
    expect(hover('amount')).toMatchObject({ code: 'uniform float amount', doc: expect.stringContaining('How much of it.') });
    expect(hover('isf_vertShaderInit')?.code).toBe('void isf_vertShaderInit()');
    expect(hover('gl_Position')?.code).toBe('vec4 gl_Position');
    const labels = completionsAt(below, placeIn(vertex, 'amount')).map(({ label }) => label);
    expect(labels).toEqual(expect.arrayContaining(['amount', 'left', 'gl_Position', 'isf_vertShaderInit']));
    expect(labels).not.toContain('gl_FragColor');
  });

  test('shares the names of what it hands on, and of inputs, when they are renamed', () => {
    const { above, below } = documents();
    const both = (place: Place, to: string, from: typeof above, other: typeof above) => {
      const options = { ...texts, ...(from === below ? { fragment } : {}) };
      const here = renameAt(from, place, to, options);
      const there = renameBeside(from, place, to, other, from === below ? texts : { ...texts, fragment });
      if (!here.ok || !there.ok) return [here, there];
      return [applyEdits(from.source, here.edits), applyEdits(other.source, there.edits)];
    };
    const renamed = [fragment.source.replaceAll('left', 'nearby'), vertex.replaceAll('left', 'nearby')];
    expect(both(placeIn(fragment.source, 'left'), 'nearby', above, below)).toEqual(renamed);
    expect(both(placeIn(vertex, 'left'), 'nearby', below, above)).toEqual([...renamed].reverse());
    const louder = (text: string) => text.replaceAll('amount', 'gain');
    expect(both(placeIn(fragment.source, 'amount;'), 'gain', above, below)).toEqual([louder(fragment.source), louder(vertex)]);
  });

  test('keeps its own names to itself, and refuses what would hide or be taken', () => {
    const { above, below } = documents();
    const there = (text: string, to: string, from = below, other = above) =>
      renameBeside(from, placeIn(from.source, text), to, other, from === below ? texts : { ...texts, fragment });
    expect(there('step', 'width')).toEqual({ ok: true, edits: [] });
    expect(there('left', 'amount')).toMatchObject({ ok: false, reason: expect.stringContaining('shaders/a.fs') });
    expect(there('left;', 'step', above, below)).toMatchObject({ ok: false, reason: expect.stringContaining('shaders/a.vs') });
    expect(renameStart(below, placeIn(vertex, 'amount'))).toMatchObject({
      ok: false,
      reason: expect.stringContaining('header of shaders/a.fs'),
    });
  });
});
