export type BlendMode = 'opaque' | 'alpha-blend' | 'additive';

/** RGBA, 8 bits, rows from the top. */
export interface Pixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly rgba: Uint8Array;
}

/**
 * Composites the page's premultiplied layer with the room, as the user of the device sees it: `alpha-blend` draws the layer over the room,
 * `additive` adds it (WebXR Augmented Reality Module §3.2). Integer arithmetic gives the same result on every machine.
 */
export function compositePixels(layer: Pixels, room: Pixels, blend: BlendMode): Pixels {
  const rgba = new Uint8Array(layer.rgba.length);
  for (let i = 0; i < rgba.length; i += 4) {
    const alpha = layer.rgba[i + 3] ?? 0;
    for (let c = i; c < i + 3; c++) {
      const above = layer.rgba[c] ?? 0;
      const below = room.rgba[c] ?? 0;
      rgba[c] = Math.min(255, above + behind(below, alpha, blend));
    }
    rgba[i + 3] = 255;
  }
  return { widthPx: layer.widthPx, heightPx: layer.heightPx, rgba };
}

/** Flips rows read from WebGL, which come from the bottom. */
export function turnRows(rgba: Uint8Array, widthPx: number, heightPx: number): Pixels {
  const out = new Uint8Array(rgba.length);
  const rowBytes = widthPx * 4;
  for (let row = 0; row < heightPx; row++) {
    out.set(rgba.subarray(row * rowBytes, (row + 1) * rowBytes), (heightPx - 1 - row) * rowBytes);
  }
  return { widthPx, heightPx, rgba: out };
}

function behind(below: number, alpha: number, blend: BlendMode): number {
  if (blend === 'opaque') return 0;
  return blend === 'additive' ? below : Math.round((below * (255 - alpha)) / 255);
}
