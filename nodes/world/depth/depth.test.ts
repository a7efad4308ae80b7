import { expect, test } from '@jest/globals';
import { LIBRARY } from '../../../tests/support/library.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { readShader } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';
import type { RoomDepth, SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const LEFT = { widthPx: 1 } as RoomDepth;
const RIGHT = { widthPx: 2 } as RoomDepth;

function frame(viewCount: number, ...depths: (RoomDepth | null)[]): SessionFrame {
  return { viewCount, views: depths.map((depth) => ({ depth })) } as unknown as SessionFrame;
}

test('hands on the depth of each view as it is measured, and none of views that are over', () => {
  const { ctx } = fakeContext(definition, { params: { filter: 'nearest', fillHoles: false } });
  ctx.outputs.depth.views.push(null, null);
  const node = create(ctx);
  node.update(frame(2, LEFT, RIGHT));
  expect(ctx.outputs.depth.views).toEqual([LEFT, RIGHT]);
  // The session keeps its second view's object, valid or not.
  node.update(frame(1, LEFT, RIGHT));
  expect(ctx.outputs.depth.views).toEqual([LEFT, null]);
  node.update(frame(2, null, RIGHT));
  expect(ctx.outputs.depth.views).toEqual([null, RIGHT]);
});

test('says that its depth may have changed: in every frame of a device, in new ones of a recording, and not while there is none', () => {
  const { ctx } = fakeContext(definition, { params: { filter: 'nearest', fillHoles: false, smoothingS: 0 } });
  ctx.outputs.depth.views.push(null);
  const node = create(ctx);
  const changes = (version: number | undefined, depth: RoomDepth | null): boolean => {
    const before = node.version;
    node.update({ ...frame(1, depth), ...(version === undefined ? {} : { version }) });
    return node.version !== before;
  };
  expect([changes(undefined, null), changes(undefined, null)]).toEqual([false, false]);
  expect([changes(undefined, LEFT), changes(undefined, LEFT), changes(undefined, null)]).toEqual([true, true, true]);
  expect([changes(4, LEFT), changes(4, LEFT), changes(5, LEFT)]).toEqual([true, false, true]);
});

test('asks for depth where the device measures it, for the camera where its edges count, and never requires either', () => {
  const asked = (params: Record<string, string>) =>
    new TestStudio({ library: LIBRARY, readShader })
      .add('box-a', 'objects/primitive')
      .add('scene-a', 'layer/scene')
      .add('room-a', 'world/depth', params)
      .add('hide-a', 'layer/depth-occlusion')
      .add('screen-a', 'output/screen')
      .wire(
        'box-a.objects -> scene-a.objects',
        'scene-a.layer -> hide-a.layer',
        'room-a.depth -> hide-a.depth',
        'hide-a.layer -> screen-a.layer',
      )
      .compile()
      .output?.needs.map(({ capability, required }) => [capability, required]);
  expect(asked({})).toEqual([['depth', false]]);
  expect(asked({ filter: 'edge-aware' })).toEqual([
    ['camera-image', false],
    ['depth', false],
  ]);
  expect(asked({ source: 'picture' })).toEqual([]);
});

test('keeps “Linear”, the default of its first version, in projects of that version', () => {
  const [first] = definition.migrations ?? [];
  expect([first?.({}), first?.({ filter: 'nearest' })]).toEqual([{ filter: 'linear' }, { filter: 'nearest' }]);
});

test('rates the depth only where something reads its confidence', () => {
  const outputsWith = (...wires: string[]) =>
    new TestStudio({ library: LIBRARY, readShader })
      .add('box-a', 'objects/primitive')
      .add('scene-a', 'layer/scene')
      .add('room-a', 'world/depth')
      .add('hide-a', 'layer/depth-occlusion')
      .add('keep-a', 'operator/mask')
      .add('screen-a', 'output/screen')
      .wire('box-a.objects -> scene-a.objects', 'scene-a.layer -> hide-a.layer', 'room-a.depth -> hide-a.depth', ...wires)
      .compile()
      .output?.operations.flatMap((operation) => (operation.kind === 'source' ? Object.keys(operation.outputs) : []));
  expect(outputsWith('hide-a.layer -> screen-a.layer')).toEqual(['depth']);
  const masked = ['hide-a.layer -> keep-a.inputImage', 'room-a.confidence -> keep-a.mask', 'keep-a.layer -> screen-a.layer'];
  expect(outputsWith(...masked)).toEqual(['depth', 'confidence']);
});
