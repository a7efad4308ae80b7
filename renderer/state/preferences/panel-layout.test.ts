import { describe, expect, test } from '@jest/globals';
import { PHONE_SHAPE } from '../editor/preview-state.ts';
import { arrangeSide, loadLayout } from './panel-layout.ts';

const storing = (text: string | null) => ({ getItem: () => text });

describe('the layout of panels', () => {
  test.each([
    [1024, 768],
    [1440, 900],
    [2560, 1440],
  ])('gives the preview 40 %% of a window of %i × %i, and leaves room for the inspector', (width, height) => {
    const { sizes, dock } = loadLayout(storing(null), width, height);
    expect(dock).toBe('right');
    expect(sizes.sideWidthPx).toBeGreaterThanOrEqual(Math.floor(width * 0.4));
    expect(height - sizes.previewHeightPx).toBeGreaterThan(height * 0.4);
  });

  test.each([
    [1024, 768],
    [1440, 900],
    [2560, 1440],
  ])('gives an upright phone about twice the area that it has in a 4:3 panel or more, in a window of %i × %i', (width, height) => {
    const { sizes } = loadLayout(storing(null), width, height);
    const around = { rail: 33, case: 24, transport: 38, bars: 70 };
    const phoneHeight = (widthPx: number, heightPx: number) =>
      Math.min(heightPx - around.transport - around.case, (widthPx - around.rail - around.case) / PHONE_SHAPE);
    const side = arrangeSide(PHONE_SHAPE, sizes, width);
    const now =
      side.place === 'beside'
        ? phoneHeight(sizes[side.side] - sizes[side.inspector], height - around.bars)
        : phoneHeight(sizes[side.side], sizes[side.preview]);
    const before = phoneHeight(sizes.sideWidthPx, sizes.previewHeightPx);
    expect((now / before) ** 2).toBeGreaterThan(width < 1200 ? 1.8 : 2);
    expect(sizes[side.side]).toBeLessThanOrEqual(width / 2);
  });

  test('leaves the graph half of a window that became narrow, whatever a phone took of the wide one', () => {
    const { sizes } = loadLayout(storing(null), 1440, 900);
    expect(arrangeSide(PHONE_SHAPE, sizes, 1440)).toMatchObject({ place: 'beside', graphLeastPx: 360 });
    expect(arrangeSide(PHONE_SHAPE, sizes, 1100)).toMatchObject({ place: 'beside', graphLeastPx: 550 });
    // Half of it is too narrow for phone and inspector side by side.
    expect(arrangeSide(PHONE_SHAPE, sizes, 1024)).toMatchObject({ place: 'above', graphLeastPx: 512 });
  });

  test('keeps stored sizes, the dock and the device frame, and replaces invalid ones', () => {
    const stored = '{"sideWidthPx":500,"previewHeightPx":-3,"bottomHeightPx":"x","dock":"left","frame":"phone"}';
    const { sizes, dock, frame } = loadLayout(storing(stored), 1440, 900);
    const defaults = loadLayout(storing('[nonsense'), 1440, 900).sizes;
    expect(dock).toBe('left');
    expect(frame).toBe('phone');
    expect(sizes).toEqual({ ...defaults, sideWidthPx: 500 });
    expect(loadLayout(storing('{"dock":"above","frame":"tv"}'), 1440, 900)).toMatchObject({ dock: 'right', frame: 'auto' });
  });
});
