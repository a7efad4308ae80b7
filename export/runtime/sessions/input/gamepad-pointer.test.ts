import { describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../session-frame.ts';
import { createGamepadPointer } from './gamepad-pointer.ts';
import { createSessionInput, deriveTaps } from './session-input.ts';

/** A view of 90° both ways, 200 × 100 pixels; the camera is at the origin. */
function start() {
  const [view] = createSessionFrame().views;
  if (!view) throw new Error('A frame has views.');
  Object.assign(view, { viewport: { x: 0, y: 0, widthPx: 200, heightPx: 100 } });
  view.clipFromView.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0]);
  view.worldFromView.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  const cursor: (readonly number[] | null)[] = [];
  const pointer = createGamepadPointer((u, v) => cursor.push(u === null ? null : [u, v]));
  const input = createSessionInput();
  const frame = (x: number, y: number, primary = false, deltaS = 0.1, connected = true) => {
    input.pointerCount = 0;
    input.left.connected = input.right.connected = connected;
    input.left.stick.set([x, y]);
    input.right.primary = primary;
    pointer.fill(input, view, deltaS);
    deriveTaps(input);
    const shown = input.pointerCount > 0 ? input.pointers[0] : null;
    return shown ? shown.phase : null;
  };
  /** Where the ray meets the plane one meter ahead. */
  const aim = () => {
    const m = input.pointers[0]?.worldFromRay ?? [];
    return [(m[8] ?? 0) / (m[10] ?? 1), (m[9] ?? 0) / (m[10] ?? 1)].map((x) => Math.round(-x * 1e3) / -1e3 + 0);
  };
  return { cursor, input, frame, aim };
}

describe('a gamepad as a pointer', () => {
  test('is none until the stick moves, and begins in the middle', () => {
    const { cursor, frame, aim } = start();
    expect([frame(0, 0), frame(0.1, 0.1), cursor]).toEqual([null, null, []]);
    expect(frame(0.21, 0)).toBe('hover');
    expect(aim()).toEqual([expect.closeTo(0, 3), 0]);
  });

  test('the cursor moves by heights of the view, alike along both sides, and stays within it', () => {
    const { cursor, frame } = start();
    frame(0, 1);
    // 0.7 heights a second, for 0.1 s.
    expect(cursor.at(-1)).toEqual([0.5, expect.closeTo(0.57, 6)]);
    frame(1, 0);
    // The view is twice as wide as it is high.
    expect(cursor.at(-1)).toEqual([expect.closeTo(0.535, 6), expect.closeTo(0.57, 6)]);
    for (let i = 0; i < 50; i++) frame(1, 1);
    expect(cursor.at(-1)).toEqual([1, 1]);
    // A frame that was held up for ten seconds.
    frame(-1, 0, false, 10);
    expect(cursor.at(-1)?.[0]).toBeGreaterThan(0.9);
  });

  test('its ray goes through the cursor, for Pick and Place', () => {
    const { cursor, frame, input } = start();
    for (let i = 0; i < 3; i++) frame(1, 0.5);
    const [u = 0, v = 0] = cursor.at(-1) ?? [];
    const m = input.pointers[0]?.worldFromRay ?? [];
    const depth = m[10] ?? 1;
    expect([-(m[8] ?? 0) / depth, -(m[9] ?? 0) / depth]).toEqual([expect.closeTo(2 * u - 1, 5), expect.closeTo(2 * v - 1, 5)]);
  });

  test('A presses: start, hold, end; at rest it is a tap, moved it is a drag', () => {
    const { frame, input } = start();
    frame(0.5, 0);
    expect([frame(0, 0, true), frame(0, 0, true), frame(0, 0), input.tapCount]).toEqual(['start', 'hold', 'end', 1]);
    expect([frame(0, 0), input.tapCount]).toEqual(['hover', 0]);
    expect([frame(0, 0, true), frame(1, 0, true), frame(0, 0), input.tapCount]).toEqual(['start', 'hold', 'end', 0]);
    expect(new Set([input.pointers[0]?.id, input.pointers[0]?.by])).toEqual(new Set([1 << 19, 'mouse']));
  });

  test('a gamepad that is unplugged in a press cancels it', () => {
    const { frame, input } = start();
    expect([frame(0, 0, true), frame(0, 0, false, 0.1, false), input.tapCount]).toEqual(['start', 'cancel', 0]);
  });

  test('vanishes after a rest, not during a press', () => {
    const { cursor, frame } = start();
    frame(1, 0);
    for (let i = 0; i < 100; i++) expect(frame(0, 0, true)).not.toBe(null);
    frame(0, 0);
    for (let i = 0; i < 50; i++) frame(0, 0);
    expect([frame(0, 0), cursor.at(-1)]).toEqual([null, null]);
    expect(frame(1, 0)).toBe('hover');
  });
});
