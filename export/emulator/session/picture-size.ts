import type { World } from '../world.ts';

/** Current size of the framebuffer with all views. The width is even, so that two views have equal sizes. */
export function pictureSizePx({ settings, screen }: World, scale: number): [widthPx: number, heightPx: number] {
  const [widthPx, heightPx] = settings.sizePx ?? screen.sizePx();
  return [Math.max(2, Math.round((widthPx * scale) / 2) * 2), Math.max(1, Math.round(heightPx * scale))];
}
