import type { Locator } from 'playwright-core';

/** A point in client pixels. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Waits until the element no longer moves, because views scroll smoothly. */
export async function centerOf(locator: Locator): Promise<Point> {
  await locator.evaluate(async (element) => {
    const placed = () => new Promise<DOMRect>((done) => requestAnimationFrame(() => done(element.getBoundingClientRect())));
    for (let last = await placed(), same = 0; same < 2; ) {
      const next = await placed();
      same = next.x === last.x && next.y === last.y ? same + 1 : 0;
      last = next;
    }
  });
  const box = await locator.boundingBox();
  if (!box) throw new Error(`${locator} is not on screen.`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
