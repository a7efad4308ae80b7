import { describe, expect, test } from '@jest/globals';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { drawPicture, linkText, made, PAGE } from '../browser/glsl-kit.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt } from '../support/image.ts';
import { CONVERSIONS, type ExpressionIdiom, NAMES, STATEMENTS, WORDS } from './isf-idioms/expressions.ts';
import { FILES } from './isf-idioms/files.ts';

const page = useModule(PAGE);

describe.each<readonly [string, readonly ExpressionIdiom[]]>([
  ['conversions', CONVERSIONS],
  ['names', NAMES],
  ['statements', STATEMENTS],
  ['words of newer GLSL', WORDS],
])('%s', (_, idioms) => {
  test.each(idioms)('%s', async (_name, declarations, expression, wanted) => {
    const source = `/*{ "ISFVSN": "2" }*/\n${declarations}\nvoid main() { gl_FragColor = vec4(vec3(float(${expression})), 1.0); }`;
    const hasLoop = /\b(for|while|do)\b/.test(declarations);
    for (const loopBudget of hasLoop ? [false, true] : [false]) {
      const picture = await drawPicture(page, { width: 8, height: 8, passes: linkText(source, { loopBudget }) });
      expect(pixelAt(picture, 3, 3)[0] / 255).toBeCloseTo(wanted, 2);
    }
  });
});

test.each(FILES)('$name', async ({ header, code, vertex = null, wanted, frames = 1 }) => {
  const shader = made(readIsf(header + code, 'test.fs', vertex));
  const pictures = shader.inputs.filter(({ type }) => /^(image|audio|audioFFT)$/.test(type)).map(({ name }) => name);
  const picture = await drawPicture(page, {
    width: 8,
    height: 8,
    passes: made(linkIsf(shader, { node: 'test', absent: pictures })),
    params: Object.fromEntries(shader.inputs.map((input) => [input.name, input.type === 'event' ? 0 : input.default])),
    frames,
  });
  pixelAt(picture, 3, 3).forEach((value, i) => {
    expect(Math.abs(value - (wanted[i] ?? 0))).toBeLessThanOrEqual(1);
  });
});
