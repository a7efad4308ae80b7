import { describe, expect, test } from '@jest/globals';
import { LIBRARY } from '../../../tests/support/library.ts';
import { readShader } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';

/** The strength of a filter by an expression node, whose result is on screen. */
function studio(expression: string): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('formula-a', 'value/expression', { expression })
    .add('sepia-a', 'filter/sepia')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> sepia-a.inputImage', 'formula-a.result -> sepia-a.amount', 'sepia-a.layer -> screen-a.layer');
}

describe('mistakes in the expression of a node', () => {
  test('are reported with node, param and column, and nothing is compiled', () => {
    const { output, diagnostics } = studio('a + e').compile();
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR022', severity: 'error', nodeId: 'formula-a', port: 'expression', column: 5 }]);
    expect(diagnostics[0]?.message).toContain('Unknown name “e”; use one of a, b, c, d, time, frame, pi, tau');
  });

  test('do not stop an output that does not depend on the node', () => {
    const { output, diagnostics } = studio('a +').unwire('formula-a.result -> sepia-a.amount').compile();
    expect(output?.operations.map(({ node }) => node)).not.toContain('formula-a');
    expect(diagnostics).toMatchObject([{ code: 'SCR022', severity: 'warning', nodeId: 'formula-a' }]);
  });

  test('a, b, c and d are the node’s own: no param elsewhere knows them', () => {
    expect(studio('a + b * c - d').compile().diagnostics).toEqual([]);
    const bound = studio('a').bind('formula-a.a', { expression: 'b * 2' });
    expect(bound.compile().diagnostics).toMatchObject([{ code: 'SCR022', nodeId: 'formula-a', port: 'a', column: 1 }]);
  });

  test('the runtime is given postfix, not the text', () => {
    const operation = studio('a + time')
      .compile()
      .output?.operations.find(({ node }) => node === 'formula-a');
    expect(operation).toMatchObject({ type: 'value/expression', config: { expression: 'a time +' } });
  });
});
