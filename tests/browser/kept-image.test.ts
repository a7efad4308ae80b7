import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/kept-image.page.ts');

type Images = Readonly<Record<'moved' | 'back' | 'relit', Uint8Array>> & {
  readonly still: readonly Uint8Array[];
  readonly kept: number;
  readonly drawn: number;
};

test('a room is drawn once for eyes that stay, byte for byte, and again when they move or its light does', async () => {
  const { still, kept, moved, drawn, back, relit } = await page.call<Images>('images');
  const [first = new Uint8Array(), ...later] = still.map((image) => Buffer.from(image));
  expect(new Set(first).size).toBeGreaterThan(20);
  for (const image of [...later, back]) expect(Buffer.compare(first, image)).toBe(0);
  for (const image of [moved, relit]) expect(Buffer.compare(first, image)).not.toBe(0);
  expect(kept).toBe(2);
  expect(drawn).toBeGreaterThan(100);
});
