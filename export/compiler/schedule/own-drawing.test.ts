import { expect, test } from '@jest/globals';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { definition as capture } from '../../../nodes/source/capture/definition.ts';
import { definition as splats } from '../../../nodes/source/splats/definition.ts';
import { draws, passes } from '../../../tests/compile/compiled.ts';
import { readShader, TEST_LIBRARY } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';
import type { Program } from '../../program/program.ts';
import { compile } from '../compile.ts';

const DRAWN = { capture, splats } as const;
const LIBRARY: NodeLibrary = {
  ...TEST_LIBRARY,
  definition: (type) => Object.values(DRAWN).find((definition) => definition.type === type) ?? TEST_LIBRARY.definition(type),
};

/** A node that draws itself, behind the room or not, and a filter after it or not. */
function program(kind: keyof typeof DRAWN, { hidden = false, filtered = false } = {}): Program {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .asset('file', { path: 'assets/a', kind })
    .add('own-a', `source/${kind}`, { file: 'file' })
    .add('room-a', 'world/depth')
    .add('hide-a', 'layer/depth-occlusion')
    .add('sobel-a', 'filter/sobel-edges')
    .add('screen-a', 'output/screen')
    .wire('own-a.layer -> hide-a.layer', 'room-a.depth -> hide-a.depth');
  const layer = hidden ? 'hide-a.layer' : 'own-a.layer';
  if (filtered) studio.wire(`${layer} -> sobel-a.inputImage`, 'sobel-a.layer -> screen-a.layer');
  else studio.wire(`${layer} -> screen-a.layer`);
  const { output } = compile({ project: studio.project, library: LIBRARY });
  if (output === null) throw new Error('It does not compile.');
  return output;
}

test('splats are hidden by the room while they are drawn, captures by a pass', () => {
  const hidden = program('splats', { hidden: true });
  expect(draws(hidden)).toMatchObject([{ target: 'screen', ownDrawing: true, occlusion: { node: 'hide-a', roomDepth: 'room-a.depth' } }]);
  expect(passes(hidden)).toEqual([]);
  const captured = program('capture', { hidden: true });
  expect(draws(captured)).toMatchObject([{ target: 'own-a.layer', occlusion: null }]);
  expect(passes(captured)).toHaveLength(1);
});

test('splats, which only blend, need neither several samples nor a depth buffer on the screen', () => {
  expect(program('splats').presentation).toMatchObject({ antialias: false, screenDepth: 'none' });
  expect(program('capture').presentation).toMatchObject({ antialias: true, screenDepth: 'whole' });
  const samples = (made: Program) => made.resources.flatMap((resource) => (resource.kind === 'target' ? [resource.samples] : []));
  expect(samples(program('splats', { filtered: true }))).toEqual([1]);
  expect(samples(program('capture', { filtered: true }))).toEqual([4]);
});
