import { expect, test } from '@jest/globals';
import { createSessionFrame } from '../../export/runtime/sessions/session-frame.ts';
import { createFrameDrawing } from './frame-drawing.ts';

const NOTHING = { kind: 'viewer', left: null, right: null, split: 1, probed: null } as const;

function createStage() {
  const clock = { asked: false, idle: true };
  const calls: string[] = [];
  const shown = { differs: false, layers: [] as string[], quiet: false };
  const player = {
    draw: () => void calls.push('draw'),
    drawChanges: () => {
      calls.push('changes');
      return shown.differs;
    },
  };
  const thumbnails = {
    beforeFrame: (_: unknown, quiet = false) => {
      shown.quiet = quiet;
      return shown.layers;
    },
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
  expect(next()).toEqual([false, 'changes']);
  shown.differs = true;
  // What has loaded late is shown by thumbnails, too.
  expect(next()).toEqual([true, 'changes', 'outdated']);
  expect(next()).toEqual([true, 'changes']);
  shown.differs = false;
  expect(next()).toEqual([false, 'changes']);
  clock.asked = true;
  expect(next()).toEqual([true, 'draw']);
});

test('a frame is drawn that is needed, or that shows another layer', () => {
  const { shown, next } = createStage();
  expect(next(NOTHING, true)).toEqual([true, 'draw']);
  for (const side of ['left', 'right', 'probed']) expect(next({ ...NOTHING, [side]: 'blur.layer' })).toEqual([true, 'draw']);
  shown.layers = ['blur.layer'];
  expect(next()).toEqual([true, 'draw']);
});

test('thumbnails rest while nothing changes by itself', () => {
  const { shown, next } = createStage();
  next();
  next();
  expect(shown.quiet).toBe(true);
  shown.differs = true;
  next();
  next();
  expect(shown.quiet).toBe(false);
});
