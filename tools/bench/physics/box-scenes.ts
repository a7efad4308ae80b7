import type { BoxWorld, RivalEngine, Vector } from './rival-engines.ts';

const SIZE_M = 0.2;
const BOX: Vector = [SIZE_M, SIZE_M, SIZE_M];
const HEAP_BOXES = 100;

/** Millimeters that the top of ten boxes is too low after ten seconds; more than a box if they fell. */
export function stackSinksMm({ open }: RivalEngine): number {
  const world = open();
  const boxes = Array.from({ length: 10 }, (_, i) => world.add(BOX, [0, (i + 0.5) * SIZE_M, 0], 0, false));
  for (let i = 0; i < 600; i++) world.step();
  return 1000 * (9.5 * SIZE_M - world.placeOf(boxes.at(-1) ?? 0)[1]);
}

/** The steepest slope in degrees on which a box stays within 5 mm for four seconds. By Coulomb it is 26.6° at a friction of 0.5. */
export function holdsOnDegrees({ open }: RivalEngine): number {
  const slidesM = (degrees: number): number => {
    const rad = (degrees * Math.PI) / 180;
    const world = open();
    // High above the floor of the world.
    const [x, y] = [-Math.sin(rad), Math.cos(rad)];
    world.add([20, 0.2, 2], [0, 20, 0], rad, true);
    const start: Vector = [SIZE_M * x, 20 + SIZE_M * y, 0];
    const box = world.add(BOX, start, rad, false);
    for (let i = 0; i < 240; i++) world.step();
    const [p, q] = world.placeOf(box);
    return Math.hypot(p - start[0], q - start[1]);
  };
  let most = 0;
  for (let degrees = 10; degrees <= 45; degrees++) if (slidesM(degrees) < 0.005) most = degrees;
  return most;
}

/** A hundred boxes that have fallen for four seconds. */
export function openHeap({ open }: RivalEngine): BoxWorld {
  const world = open();
  for (let i = 0; i < HEAP_BOXES; i++) {
    const layer = Math.floor(i / 9);
    world.add(
      BOX,
      [0.23 * (i % 3) + 0.04 * (layer % 3), 0.2 + 0.25 * layer, 0.23 * (Math.floor(i / 3) % 3) - 0.03 * (layer % 2)],
      0,
      false,
    );
  }
  for (let i = 0; i < 240; i++) world.step();
  return world;
}
