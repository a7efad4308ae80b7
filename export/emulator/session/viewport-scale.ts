/** Dynamic viewport scaling of one eye (WebXR Device API §7.2): the requested and the current scale. */
export interface ViewportScale {
  requested: number;
  current: number;
  /** The frame that read the viewport last; the scale is fixed until the next frame. */
  settledIn: object | null;
}

export interface ViewportPx {
  readonly x: number;
  readonly y: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

export function createViewportScale(): ViewportScale {
  return { requested: 1, current: 1, settledIn: null };
}

/** Clamps the requested scale to 1 and ignores invalid numbers. */
export function requestScale(scale: ViewportScale, wish: number | null | undefined): void {
  if (typeof wish === 'number' && wish > 0) scale.requested = Math.min(wish, 1);
}

/** The part of `full` that the page draws into. The first call in a frame fixes the scale. */
export function scaledViewport(scale: ViewportScale, full: ViewportPx, frame: object): ViewportPx {
  if (scale.settledIn !== frame) {
    scale.current = scale.requested;
    scale.settledIn = frame;
  }
  return partOf(scale, full);
}

function partOf({ current }: ViewportScale, { x, y, widthPx, heightPx }: ViewportPx): ViewportPx {
  return { x, y, widthPx: Math.max(1, Math.floor(widthPx * current)), heightPx: Math.max(1, Math.floor(heightPx * current)) };
}

/** Stretches the drawn part of a scaled viewport to the whole viewport, in place. `rgba` is RGBA, rows from the bottom, `widthPx` wide. */
export function stretchViewport(rgba: Uint8Array, widthPx: number, full: ViewportPx, scale: ViewportScale): void {
  const part = partOf(scale, full);
  if (part.widthPx === full.widthPx && part.heightPx === full.heightPx) return;
  // Runs from the far corner, so that no pixel is overwritten before it is read.
  for (let row = full.heightPx - 1; row >= 0; row--) {
    const fromRow = full.y + Math.floor((row * part.heightPx) / full.heightPx);
    for (let column = full.widthPx - 1; column >= 0; column--) {
      const from = (fromRow * widthPx + full.x + Math.floor((column * part.widthPx) / full.widthPx)) * 4;
      rgba.copyWithin(((full.y + row) * widthPx + full.x + column) * 4, from, from + 4);
    }
  }
}
