import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { RoomDepth, SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const LEFT = { widthPx: 1 } as RoomDepth;
const RIGHT = { widthPx: 2 } as RoomDepth;

function frame(viewCount: number, ...depths: (RoomDepth | null)[]): SessionFrame {
  return { viewCount, views: depths.map((depth) => ({ depth })) } as unknown as SessionFrame;
}

test('hands on the depth of each view, and none of views that are over', () => {
  const { ctx } = fakeContext(definition);
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

test('is never required: a page without depth still plays', () => {
  expect(definition.needs).toEqual([expect.objectContaining({ capability: 'depth', required: false })]);
});
