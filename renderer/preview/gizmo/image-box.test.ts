import { describe, expect, test } from '@jest/globals';
import { imageBox } from './image-box.ts';

type Seen = Parameters<typeof imageBox>[0];

/** A wide view of 400 × 200 px, half as large on the page. */
const VIEW = { viewport: { x: 0, y: 0, widthPx: 400, heightPx: 200 } };
const BOX = { left: 10, top: 20, width: 200, height: 100 };

/** A filter on an image of 100 × 100 pixels, whose result another one blurs; the pass that shows it fits it to the view. */
function square(fit: 'cover' | 'contain' | 'stretch'): Seen {
  const read = (resource: string, how: string) => [{ name: 'image', source: { kind: 'color', resource }, fit: how }];
  const operations = [
    { kind: 'pass', node: 'swirl', target: 'swirl.out', samplers: [] },
    { kind: 'pass', node: 'blur', target: 'blur.out', samplers: read('swirl.out', 'none') },
    { kind: 'pass', node: 'blur', target: 'screen', samplers: read('blur.out', fit) },
  ];
  const resources = ['swirl.out', 'blur.out'].map((id) => ({ id, kind: 'target', domain: 'image' }));
  const live = { kind: 'target', target: { peek: () => ({ widthPx: 100, heightPx: 100 }) } };
  return { program: { operations, resources }, resources: new Map(['swirl.out', 'blur.out'].map((id) => [id, live])) } as unknown as Seen;
}

describe('the place of an image on the page', () => {
  test('is that of the view for layers of the view', () => {
    const seen = {
      program: { operations: [{ kind: 'pass', node: 'swirl', target: 'screen', samplers: [] }], resources: [] },
      resources: new Map(),
    };
    expect(imageBox(seen as unknown as Seen, 'swirl', VIEW, BOX)).toEqual({ ...BOX, scale: 2 });
  });

  test('follows how later passes fit it to the view', () => {
    expect(imageBox(square('stretch'), 'swirl', VIEW, BOX)).toEqual({ ...BOX, scale: 1 });
    for (const node of ['swirl', 'blur'])
      expect(imageBox(square('contain'), node, VIEW, BOX)).toEqual({ left: 60, top: 20, width: 100, height: 100, scale: 1 });
    expect(imageBox(square('cover'), 'swirl', VIEW, BOX)).toEqual({ left: 10, top: -30, width: 200, height: 200, scale: 0.5 });
  });
});
