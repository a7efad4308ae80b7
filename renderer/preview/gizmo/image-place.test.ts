import { describe, expect, test } from '@jest/globals';
import {
  ARM_PX,
  draggedValues,
  type ImageBox,
  type ImagePart,
  onPage,
  type PagePoint,
  partAt,
  partsOf,
  readImagePlace,
  turnBetween,
} from './image-place.ts';
import type { HandleNames } from './place.ts';

/** An image of 800 × 400 pixels, half as large on the page. */
const BOX: ImageBox = { left: 100, top: 50, width: 400, height: 200, scale: 2 };
const SWIRL: HandleNames = { center: 'center', extent: 'radius', angle: 'angle' };
const REGION: HandleNames = { low: 'min', high: 'max' };

function setUp(handles: HandleNames, values: Readonly<Record<string, readonly number[]>>) {
  const place = readImagePlace(handles, (param) => values[param] ?? null);
  const pointOf = (part: ImagePart): PagePoint => {
    const found = partsOf(handles, place, BOX).find((each) => JSON.stringify(each.part) === JSON.stringify(part));
    if (!found) throw new Error('There is no such part.');
    return found.at;
  };
  const drag = (part: ImagePart, x: number, y: number, snaps = false) => {
    const start = pointOf(part);
    const to = { x: start.x + x, y: start.y + y };
    return draggedValues(
      handles,
      { part, from: place, start, to, turnedRad: turnBetween(onPage(place.center, BOX), start, to), snaps },
      BOX,
    );
  };
  return { place, pointOf, drag };
}

describe('a center with a radius and an angle', () => {
  const values = { center: [0.25, 0.75], radius: [120], angle: [Math.PI / 2] };

  test('stands where the shader has it: the origin is at the bottom left, angles turn counterclockwise', () => {
    const { pointOf } = setUp(SWIRL, values);
    expect(pointOf({ kind: 'center' })).toEqual({ x: 200, y: 100 });
    expect(pointOf({ kind: 'extent' })).toEqual({ x: 200, y: 160 });
    const { x, y } = pointOf({ kind: 'angle' });
    expect([x, y]).toEqual([expect.closeTo(200, 6), 100 - ARM_PX]);
  });

  test('follows the pointer within the image', () => {
    const { drag } = setUp(SWIRL, values);
    expect(drag({ kind: 'center' }, 40, 20)).toEqual({ center: [expect.closeTo(0.35, 6), expect.closeTo(0.65, 6)] });
    expect(drag({ kind: 'center' }, -900, 0)).toEqual({ center: [0, 0.75] });
    expect(drag({ kind: 'extent' }, 0, 10)).toEqual({ radius: 140 });
    // A quarter turn to the left.
    expect(drag({ kind: 'angle' }, -ARM_PX, ARM_PX)).toEqual({ angle: expect.closeTo(Math.PI, 6) });
  });

  test('snaps to 5 % of the image, 10 px and 15°', () => {
    const { drag } = setUp(SWIRL, values);
    expect(drag({ kind: 'center' }, 43, 0, true)).toEqual({ center: [expect.closeTo(0.35, 6), 0.75] });
    expect(drag({ kind: 'extent' }, 0, 7, true)).toEqual({ radius: 130 });
    expect(drag({ kind: 'angle' }, -10, 0, true)).toEqual({ angle: expect.closeTo((105 * Math.PI) / 180, 6) });
  });

  test('is found by its dots and by all of its circle', () => {
    const { place } = setUp(SWIRL, values);
    expect(partAt(SWIRL, place, BOX, { x: 203, y: 98 })).toEqual({ kind: 'center' });
    expect(partAt(SWIRL, place, BOX, { x: 262, y: 100 })).toEqual({ kind: 'extent' });
    expect(partAt(SWIRL, place, BOX, { x: 230, y: 100 })).toBeNull();
  });
});

describe('a rectangle', () => {
  const values = { min: [0.25, 0.25], max: [0.75, 0.5] };

  test('is dragged by its corners, its sides and its middle', () => {
    const { drag, pointOf } = setUp(REGION, values);
    expect(pointOf({ kind: 'rectangle', x: -1, y: 1 })).toEqual({ x: 200, y: 150 });
    expect(drag({ kind: 'rectangle', x: -1, y: 1 }, -40, -20)).toEqual({
      min: [expect.closeTo(0.15, 6), 0.25],
      max: [0.75, expect.closeTo(0.6, 6)],
    });
    expect(drag({ kind: 'rectangle', x: 1, y: 0 }, 40, 20)).toEqual({ min: [0.25, 0.25], max: [expect.closeTo(0.85, 6), 0.5] });
    expect(drag({ kind: 'rectangle', x: 0, y: 0 }, 40, -20)).toEqual({
      min: [expect.closeTo(0.35, 6), expect.closeTo(0.35, 6)],
      max: [expect.closeTo(0.85, 6), expect.closeTo(0.6, 6)],
    });
  });

  test('stays in the image, keeps its size when it is moved, and never turns inside out', () => {
    const { drag } = setUp(REGION, values);
    expect(drag({ kind: 'rectangle', x: 0, y: 0 }, 900, 900)).toEqual({ min: [0.5, 0], max: [1, 0.25] });
    const { min, max } = drag({ kind: 'rectangle', x: 1, y: 1 }, -900, 900) as { min: number[]; max: number[] };
    expect(min).toEqual([0.25, 0.25]);
    expect(max[0]).toBeGreaterThan(0.25);
    expect(max[1]).toBeGreaterThan(0.25);
  });
});

test('turns add up beyond half a turn', () => {
  const center = { x: 0, y: 0 };
  let turned = 0;
  let last = { x: 10, y: 0 };
  for (let i = 1; i <= 16; i++) {
    const next = { x: 10 * Math.cos((i * Math.PI) / 4), y: -10 * Math.sin((i * Math.PI) / 4) };
    turned += turnBetween(center, last, next);
    last = next;
  }
  expect(turned).toBeCloseTo(4 * Math.PI, 6);
});
