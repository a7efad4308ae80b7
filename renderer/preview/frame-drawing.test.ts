import { expect, test } from '@jest/globals';
import { createSessionFrame } from '../../export/runtime/sessions/session-frame.ts';
import { createFrameDrawing } from './frame-drawing.ts';

const NOTHING = { kind: 'viewer', left: null, right: null, split: 1, probed: null } as const;

function createStage() {
  const clock = { asked: false, idle: true };
  const calls: string[] = [];
  const shown = { differs: false, layers: [] as string[], outdated: false };
  const player = {
    draw: () => void calls.push('draw'),
    drawChanges: () => {
      calls.push('changes');
      return shown.differs;
    },
  };
  const thumbnails = {
    beforeFrame: () => shown.layers,
    get outdated() {
      return shown.outdated;
    },
    skip: () => void calls.push('skip'),
    invalidate: () => void calls.push('outdated'),
  };
  const draw = createFrameDrawing({ clock, gate: { show: () => {} }, thumbnails });
  const next = (viewer: Parameters<typeof draw>[2] = NOTHING, needed = false) => {
    calls.length = 0;
    return [draw(player, createSessionFrame(), viewer, needed), ...calls];
  };
  return { clock, shown, next };
}

test('a frame that nothing asks for is drawn only if it differs', () => {
  const { clock, shown, next } = createStage();
  expect(next()).toEqual([false, 'changes', 'skip']);
  shown.differs = true;
  // What has loaded late is shown by thumbnails, too.
  expect(next()).toEqual([true, 'changes', 'outdated']);
  expect(next()).toEqual([true, 'changes']);
  shown.differs = false;
  expect(next()).toEqual([false, 'changes', 'skip']);
  clock.asked = true;
  expect(next()).toEqual([true, 'draw']);
});

test('a frame is drawn that is needed, or that shows another layer', () => {
  const { next } = createStage();
  expect(next(NOTHING, true)).toEqual([true, 'draw']);
  for (const side of ['left', 'right', 'probed']) expect(next({ ...NOTHING, [side]: 'blur.layer' })).toEqual([true, 'draw']);
});

test('thumbnails that are not outdated are read again only in frames that differ, while time stands', () => {
  const { clock, shown, next } = createStage();
  shown.layers = ['blur.layer'];
  expect(next()).toEqual([false, 'changes', 'skip']);
  shown.outdated = true;
  expect(next()).toEqual([true, 'draw']);
  shown.outdated = false;
  clock.idle = false;
  expect(next()).toEqual([true, 'draw']);
});
