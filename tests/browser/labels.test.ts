import { beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { projectText } from '../support/project-kit.ts';
import type { Seen } from './labels.page.ts';

const page = useModule('tests/browser/labels.page.ts');

function compileLabel(params: Readonly<Record<string, unknown>>): Program {
  const text = projectText({
    nodes: {
      'pose-x1': ['pose/from-values', { positionM: [0, 0, -2] }],
      'label-x1': ['objects/label', { a: 1.2, background: [1, 0, 1, 1], facing: 'pose', liftM: 0, sizeM: 0.3, text: '{a:1 m}', ...params }],
      'scene-x1': 'layer/scene',
      'screen-x1': 'output/screen',
    },
    wires: ['pose-x1.pose -> label-x1.pose', 'label-x1.objects -> scene-x1.objects', 'scene-x1.layer -> screen-x1.layer'],
  });
  const { output, diagnostics } = loadProject({ project: text, layout: null, sources: {} });
  const compiled = output && compile({ project: output, library: LIBRARY });
  if (!compiled?.output) throw new Error(JSON.stringify([diagnostics, compiled?.diagnostics]));
  return compiled.output;
}

const draw = (...surfaces: string[]) => page.call<Seen>('draw', surfaces);

describe('a label', () => {
  let program: Program;
  beforeAll(() => {
    program = compileLabel({});
  });
  beforeEach(() => page.call('open', program));

  test('writes to the page only what changes, and paints no texture there', async () => {
    expect(await draw()).toMatchObject({ texts: ['1.2 m\n'], paints: 0, center: [0, 0, 0, 0] });
    await draw();
    expect(await draw()).toMatchObject({ writes: 0, paints: 0 });
    await page.call('setParam', 'a', 1.21);
    expect(await draw()).toMatchObject({ texts: ['1.2 m\n'], writes: 0 });
    await page.call('setPosition', [0.1, 0, -2]);
    expect(await draw()).toMatchObject({ writes: 1 });
    await page.call('setParam', 'a', 1.3);
    expect((await draw()).texts).toEqual(['1.3 m\n']);
  });

  test('is painted once per text where no page is seen, and is gone from the page', async () => {
    await draw();
    await page.call('hidePage', true);
    const { texts, paints, center, error } = await draw();
    expect({ texts, paints, error }).toEqual({ texts: [], paints: 1, error: 0 });
    expect(center[3]).toBe(255);
    expect((await draw()).paints).toBe(0);
    await page.call('setParam', 'a', 2);
    expect((await draw()).paints).toBe(1);
    await page.call('setPosition', [0, 0.1, -2]);
    expect((await draw()).paints).toBe(0);
    await page.call('hidePage', false);
    expect(await draw()).toMatchObject({ texts: ['2.0 m\n'], center: [0, 0, 0, 0] });
  });

  test('fades behind a real surface', async () => {
    expect((await draw()).opacities).toEqual(['1']);
    expect((await draw('wall')).opacities).toEqual(['0.2']);
    expect((await draw()).opacities).toEqual(['1']);
  });

  test('fades behind the nearest surface, whatever else is detected behind the label', async () => {
    expect((await draw('far wall')).opacities).toEqual(['1']);
    expect((await draw('far wall', 'box')).opacities).toEqual(['0.2']);
  });

  test('is hidden while its pose is none, and behind the viewer', async () => {
    await draw();
    await page.call('setPosition', [0, 0, 2]);
    expect((await draw()).texts).toEqual([]);
    await page.call('setPosition', [0, 0, -2]);
    expect((await draw()).texts).toHaveLength(1);
    await page.call('setPosition', [1e38, 0, -2]);
    expect((await draw()).texts).toEqual([]);
  });

  test('a text of 10,000 characters is cut, with a diagnostic', async () => {
    await page.call('setParam', 'text', 'word '.repeat(2000));
    const { texts, codes } = await draw();
    expect(texts.join('').replaceAll('\n', ' ').length).toBeLessThanOrEqual(285);
    expect(texts[0]?.trim().endsWith('…')).toBe(true);
    expect(codes).toEqual(['SCR059']);
  });

  test('leaves nothing in the page when it is disposed', async () => {
    await draw();
    expect(await page.call('close')).toBe(0);
  });
});
