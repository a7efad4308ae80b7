import { expect, test } from '@jest/globals';
import { BackSide, BoxGeometry, BufferGeometry, DoubleSide, FrontSide, PlaneGeometry, SphereGeometry, TorusGeometry } from 'three';
import { isSeenFromInside } from './inward-surface.ts';

/** The same shape, whose faces are turned to the other side. */
const turned = (geometry: BufferGeometry): BufferGeometry => geometry.scale(-1, 1, 1);

/** Without the first of its six sides, and away from the origin. */
function openBox(): BufferGeometry {
  const box = new BoxGeometry(4, 2, 3).translate(10, 1, -7);
  return box.setIndex(Array.from(box.getIndex()?.array ?? []).slice(6));
}

test.each([
  ['a box', new BoxGeometry(), FrontSide, false],
  ['a room', turned(new BoxGeometry(5, 2.6, 4)), FrontSide, true],
  ['a room without index', turned(new BoxGeometry(5, 2.6, 4)).toNonIndexed(), FrontSide, true],
  ['a room without a wall', turned(openBox()), FrontSide, true],
  ['a box without a wall', openBox(), FrontSide, false],
  ['a sky sphere', new SphereGeometry(20), BackSide, true],
  ['a sphere that shows its back faces and is turned', turned(new SphereGeometry(20)), BackSide, false],
  ['a room whose walls have two sides', turned(new BoxGeometry()), DoubleSide, false],
  ['a ring', new TorusGeometry(), FrontSide, false],
  ['a sheet', new PlaneGeometry(), FrontSide, false],
  ['nothing', new BufferGeometry(), FrontSide, false],
])('%s', (_name, geometry, side, isInside) => {
  expect(isSeenFromInside(geometry, side)).toBe(isInside);
  expect(isSeenFromInside(geometry, side)).toBe(isInside);
});
