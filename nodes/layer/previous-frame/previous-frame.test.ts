import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { isfDefinition } from '../../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { definition } from './definition.ts';

const { output: shader, diagnostics } = readIsf(readFileSync(new URL('./keep.fs', import.meta.url), 'utf8'), definition.lowering.shader);

/** How a loop decays, and that each eye has its own, is proved on pixels in `tests/browser/previous-frame.test.ts`. */
describe('the shader that keeps the frame', () => {
  test('is one the definition can speak for: the same port, and colors left as they are', () => {
    expect(diagnostics).toEqual([]);
    if (!shader) throw new Error('The shader cannot be read.');
    expect(Object.keys(isfDefinition(shader, 'previous-frame').inputs)).toEqual(Object.keys(definition.inputs));
    expect(shader.premultiplied).toBe(true);
    expect(shader.passes).toHaveLength(1);
  });
});
