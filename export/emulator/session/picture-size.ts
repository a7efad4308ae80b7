import type { World } from '../world.ts';

/** Pixels of the whole picture, all views together, by now: of an even width, so that two views are of one size. */
export function pictureSizePx({ settings, screen }: World, scale: number): [widthPx: number, heightPx: number] {
  const [widthPx, heightPx] = settings.sizePx ?? screen.sizePx();
  return [Math.max(2, Math.round((widthPx * scale) / 2) * 2), Math.max(1, Math.round(heightPx * scale))];
}
