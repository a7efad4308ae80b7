import { linearFromSrgb, srgbFromLinear } from '../../../nodes/kit/color-math.ts';

export type BlendMode = 'opaque' | 'alpha-blend' | 'additive';

/** RGBA, 8 bits, rows from the top. */
export interface Pixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly rgba: Uint8Array;
}

/** Default brightness of an additive display: luminance of its white divided by that of the room's white. */
export const DISPLAY_GAIN = 2;

/**
 * Composites the page's premultiplied layer with the room, as the user of the device sees it: `alpha-blend` draws the layer over the room,
 * `additive` adds its light (WebXR Augmented Reality Module §3.2): seen = room + gain × display, in linear light.
 *
 * @param gain For `additive`: luminance of the display's white divided by that of the room's white.
 */
export function compositePixels(layer: Pixels, room: Pixels, blend: BlendMode, gain = DISPLAY_GAIN): Pixels {
  const rgba = new Uint8Array(layer.rgba.length);
  for (let i = 0; i < rgba.length; i += 4) {
    const alpha = layer.rgba[i + 3] ?? 0;
    for (let c = i; c < i + 3; c++) {
      const above = layer.rgba[c] ?? 0;
      const below = room.rgba[c] ?? 0;
      rgba[c] = blend === 'additive' ? added(below, above, gain) : Math.min(255, above + behind(below, alpha, blend));
    }
    rgba[i + 3] = 255;
  }
  return { widthPx: layer.widthPx, heightPx: layer.heightPx, rgba };
}

/**
 * Adds a channel of the display (`above`) to that of the room (`below`) in linear light. Where the display is black, the room is unchanged.
 */
function added(below: number, above: number, gain: number): number {
  return above === 0 ? below : encoded(linearFromSrgb(below / 255) + gain * linearFromSrgb(above / 255));
}

function encoded(light: number): number {
  return Math.round(255 * Math.min(1, srgbFromLinear(light)));
}

/** Reverses the order of rows: WebGL reads them from the bottom, the result has them from the top. */
export function turnRows(rgba: Uint8Array, widthPx: number, heightPx: number): Pixels {
  const out = new Uint8Array(rgba.length);
  const rowBytes = widthPx * 4;
  for (let row = 0; row < heightPx; row++) {
    out.set(rgba.subarray(row * rowBytes, (row + 1) * rowBytes), (heightPx - 1 - row) * rowBytes);
  }
  return { widthPx, heightPx, rgba: out };
}

function behind(below: number, alpha: number, blend: BlendMode): number {
  return blend === 'opaque' ? 0 : Math.round((below * (255 - alpha)) / 255);
}
