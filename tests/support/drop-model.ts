import { expect } from '@jest/globals';
import type { Page } from 'playwright-core';
import { type ChangedBox, changedBox } from './changed-box.ts';
import { dropFiles } from './drop-files.ts';
import { EditorDriver, FLAG_PX } from './editor-driver.ts';
import type { RgbaImage } from './image.ts';

/**
 * Drops a model on the floor in the preview of a window, and expects its feet at the pointer.
 *
 * @param empty The preview before.
 * @returns Where the preview has changed.
 */
export async function dropModel(window: Page, path: string, empty: RgbaImage): Promise<ChangedBox> {
  const frame = await window.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('There is no preview.');
  const at = { x: Math.round(frame.width * 0.6), y: Math.round(frame.height * 0.85) };
  const target = window.locator('.picture-drop');
  await dropFiles(window, [path], { x: frame.x + at.x, y: frame.y + at.y }, () => expect(target.isVisible()).resolves.toBe(true));
  const shown = await new EditorDriver(window).imageOtherThan(empty);
  const box = changedBox(shown, empty);
  expect(Math.abs((box.left + box.right) / 2 - at.x)).toBeLessThan(shown.width * 0.15);
  expect(Math.abs(box.bottom + FLAG_PX - at.y)).toBeLessThan(shown.height * 0.2);
  return box;
}
