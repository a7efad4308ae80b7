import { describe, expect, test } from '@jest/globals';
import { createFineDrag } from './fine-drag.ts';
import { ARM_PX, draggedValues, type ImagePart, partAt, partsOf, readImagePlace, turnBetween } from './image-place.ts';
import { type ImageBox, onPage, type PagePoint } from './page-point.ts';
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

describe('a shape', () => {
  const SHAPE: HandleNames = { center: 'center', size: 'size', angle: 'rotation', feather: 'feather' };
  /** In the middle, half as high as the image and as wide as it is high: 200 × 100 CSS pixels. */
  const values = { center: [0.5, 0.5], size: [1, 0.5], rotation: [0], feather: [0.1] };

  test('stands where its size says, in fractions of the height, and is rotated counterclockwise', () => {
    const { pointOf } = setUp(SHAPE, values);
    expect(pointOf({ kind: 'size', x: 1, y: 1 })).toEqual({ x: 400, y: 100 });
    expect(pointOf({ kind: 'size', x: -1, y: 0 })).toEqual({ x: 200, y: 150 });
    expect(pointOf({ kind: 'angle' })).toEqual({ x: 400 + ARM_PX, y: 150 });
    expect(pointOf({ kind: 'feather' })).toEqual({ x: 350, y: 210 });
    const upright = setUp(SHAPE, { ...values, rotation: [Math.PI / 2] });
    const { x, y } = upright.pointOf({ kind: 'size', x: 1, y: 1 });
    expect([x, y]).toEqual([expect.closeTo(250, 6), expect.closeTo(50, 6)]);
  });

  test('keeps the opposite side or corner where it is', () => {
    const { drag } = setUp(SHAPE, values);
    expect(drag({ kind: 'size', x: 1, y: 0 }, 40, 30)).toEqual({ size: [1.2, 0.5], center: [expect.closeTo(0.55, 6), 0.5] });
    const corner = drag({ kind: 'size', x: -1, y: -1 }, -40, 20);
    expect(corner).toEqual({ size: [1.2, expect.closeTo(0.6, 6)], center: [expect.closeTo(0.45, 6), expect.closeTo(0.45, 6)] });
    for (const angle of [0.4, 2, -1]) {
      const turned = setUp(SHAPE, { ...values, rotation: [angle] });
      const dragged = turned.drag({ kind: 'size', x: 1, y: 1 }, 13, -21);
      const after = setUp(SHAPE, { ...values, rotation: [angle], ...dragged });
      const [before, still] = [turned, after].map(({ pointOf }) => pointOf({ kind: 'size', x: -1, y: -1 }));
      expect(still).toEqual({ x: expect.closeTo(before?.x ?? 0, 6), y: expect.closeTo(before?.y ?? 0, 6) });
      const [held, moved] = [turned, after].map(({ pointOf }) => pointOf({ kind: 'size', x: 1, y: 1 }));
      expect(moved).toEqual({ x: expect.closeTo((held?.x ?? 0) + 13, 6), y: expect.closeTo((held?.y ?? 0) - 21, 6) });
    }
  });

  test('grows about a center that is connected, and never turns inside out', () => {
    const { center: _, ...fixed } = SHAPE;
    expect(setUp(fixed, values).drag({ kind: 'size', x: 1, y: 0 }, 40, 0)).toEqual({ size: [1.4, 0.5] });
    const { size } = setUp(SHAPE, values).drag({ kind: 'size', x: 0, y: 1 }, 0, 900) as { size: number[] };
    expect(size).toEqual([1, expect.closeTo(0.01, 6)]);
  });

  test('has a soft edge that follows its part, half of it outside, and snaps', () => {
    const { drag } = setUp(SHAPE, values);
    expect(drag({ kind: 'feather' }, 5, 10)).toEqual({ feather: expect.closeTo(0.2, 6) });
    expect(drag({ kind: 'feather' }, 0, -90)).toEqual({ feather: 0 });
    expect(drag({ kind: 'feather' }, 0, 3.3, true)).toEqual({ feather: expect.closeTo(0.13, 6) });
    expect(drag({ kind: 'size', x: 1, y: 0 }, 33, 0, true)).toMatchObject({ size: [expect.closeTo(1.15, 6), 0.5] });
  });

  test('has the part of its angle near the center where there is no room beside it', () => {
    expect(setUp(SHAPE, { ...values, size: [1.9, 0.5] }).pointOf({ kind: 'angle' })).toEqual({ x: 300 + ARM_PX, y: 150 });
  });
});

test('a fine drag takes the part a tenth as far, and goes on from there', () => {
  const drag = createFineDrag({ x: 100, y: 100 });
  expect(drag.move({ x: 110, y: 100 }, false)).toEqual({ x: 110, y: 100 });
  expect(drag.move({ x: 130, y: 90 }, true)).toEqual({ x: 112, y: 99 });
  expect(drag.move({ x: 131, y: 90 }, false)).toEqual({ x: 113, y: 99 });
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
