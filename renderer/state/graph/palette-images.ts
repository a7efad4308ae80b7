import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import { PALETTE_IMAGE_TYPES } from './palette-image-types.ts';

/** Images per row of the sheet `palette-images.webp`. */
export const PALETTE_COLUMNS = 12;

/**
 * Whether a node type of the library has an image: what it makes of a sample. Filters that need nothing but a layer have one; those that read
 * or write scene values do not.
 */
export function hasPaletteImage({ type, inputs, outputs: { layer } }: NodeDefinition): boolean {
  const needed = Object.values(inputs).filter(({ required }) => required);
  const [input] = needed;
  if (!type.startsWith('filter/') || layer?.type !== 'layer' || input?.type !== 'layer' || needed.length > 1) return false;
  return input.encoding !== 'scene' && layer.encoding !== 'scene';
}

/** Where the image of a type is on the sheet, as the values of `background-size` and `background-position`; null if it has none. */
export function paletteImageOf(type: string): { readonly size: string; readonly position: string } | null {
  const index = PALETTE_IMAGE_TYPES.indexOf(type);
  if (index === -1) return null;
  const rows = Math.ceil(PALETTE_IMAGE_TYPES.length / PALETTE_COLUMNS);
  const [column, row] = [index % PALETTE_COLUMNS, Math.floor(index / PALETTE_COLUMNS)];
  const share = (at: number, count: number) => `${count < 2 ? 0 : (100 * at) / (count - 1)}%`;
  return { size: `${PALETTE_COLUMNS * 100}% ${rows * 100}%`, position: `${share(column, PALETTE_COLUMNS)} ${share(row, rows)}` };
}
