import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import { TEST_LIBRARY as library } from '../support/test-library.ts';
import type { TestStudio } from '../support/test-studio.ts';
import { expectText } from '../support/texts.ts';
import { arScene, blurAfterMerging, blurBeforeMerging, fog, imageOnly, movedParams, subgraphs } from './graphs.ts';
import { programText } from './program-text.ts';

const GRAPHS: readonly (readonly [name: string, studio: () => TestStudio, options: CompileOptions])[] = [
  ['ar-scene', arScene, {}],
  ['ar-scene-tapped', arScene, { taps: ['hide-a.layer', 'scene-a.layer', 'over-a.layer', 'video-a.layer', 'nothing-a.layer'] }],
  ['blur-before-merging', blurBeforeMerging, {}],
  ['blur-after-merging', blurAfterMerging, {}],
  ['image-only', imageOnly, {}],
  ['subgraphs', subgraphs, {}],
  ['moved-params', movedParams, {}],
  ['fog', fog, {}],
];

describe('compiled, it is as it was when it was last looked at', () => {
  test.each(GRAPHS)('%s', async (name, studio, options) => {
    const { output, diagnostics } = compile({ project: studio().project, library, options });
    if (output === null) throw new Error(JSON.stringify(diagnostics));
    expect(diagnostics.filter(({ code }) => code !== 'SCR043')).toEqual([]);
    await expectText(`${name}.txt`, programText(output));
  });
});
