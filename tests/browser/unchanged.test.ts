import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { direct, leftOut, partly, shared, still } from './unchanged.page.ts';

const page = useModule('tests/browser/unchanged.page.ts');

describe('what would be drawn again as it is', () => {
  test('is not drawn while nothing changes', async () => {
    const frames = await page.call<Awaited<ReturnType<typeof still>>>('still');
    expect(frames).toEqual({
      first: [1, 255],
      same: [0, 255],
      param: [1, 128],
      'same after it': [0, 128],
      'new pixels': [1, 128],
      smaller: [1, 128],
      'same size': [0, 128],
      'other session': [1, 128],
      'after a reset': [1, 128],
      'after a full draw': [0, 128],
      'without a version': [1, 128],
      'still without one': [1, 128],
      'after a lost context': [1, 128],
    });
  });

  test('is kept by its target while other passes are drawn', async () => {
    const { own, persistent } = await page.call<Awaited<ReturnType<typeof partly>>>('partly');
    expect(own).toEqual({ draws: [3, 1, 1, 3, 1], red: 64 });
    expect(persistent).toEqual({ draws: [3, 2, 2, 3, 2], red: 64 });
  });

  test('is drawn again where its target has meanwhile held another image', async () => {
    // The third pass draws to the texture of the first, and so draws in every frame; the second keeps its image, and nobody needs the first.
    expect(await page.call<Awaited<ReturnType<typeof shared>>>('shared')).toEqual({ draws: [4, 2, 4, 2], red: 32 });
  });

  test('is drawn to the screen at once where the image has the size of the view', async () => {
    expect(await page.call<Awaited<ReturnType<typeof direct>>>('direct')).toEqual({
      'same size as the view': [1, 255],
      unchanged: [0, 255],
      'another size': [2, 255],
      // The copy has the shader of the filter here, so that its factor shows whether it was drawn.
      'a param in another size': [2, 64],
      'the size of the view again': [1, 128],
    });
  });

  test('is drawn later where the frame that changes it leaves it out', async () => {
    expect(await page.call<Awaited<ReturnType<typeof leftOut>>>('leftOut')).toEqual({ before: 255, after: 128 });
  });
});
