import { expect, test } from '@jest/globals';
import { LIBRARY } from '../../../tests/support/library.ts';
import { readShader } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';
import { compile } from '../compile.ts';

function studio(): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .add('ball-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('screen-a', 'output/screen')
    .wire('ball-a.objects -> scene-a.objects', 'scene-a.layer -> screen-a.layer');
}

test('the screen says from where visitors look around, where it differs from what is usual', () => {
  const around = (made: TestStudio) => compile({ project: made.project, library: LIBRARY }).output?.presentation.around;
  expect(around(studio())).toBeUndefined();
  expect(around(studio().set('screen-a.aroundAheadM', 1.6))).toEqual({ targetWorld: [0, 0.75, -1.6], distanceM: 2.5 });
  expect(around(studio().set('screen-a.aroundHeightM', 1.2).set('screen-a.aroundDistanceM', 4))).toEqual({
    targetWorld: [0, 1.2, 0],
    distanceM: 4,
  });
});
