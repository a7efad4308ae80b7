/** Dynamic viewport scaling of one eye (WebXR Device API §7.2): what the page asked for, and what holds in this frame. */
export interface ViewportScale {
  requested: number;
  current: number;
  /** The frame whose viewport was asked for; until the next one it stays as it is. */
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

/** Numbers that are no scale say nothing; more than all of the viewport is all of it. */
export function requestScale(scale: ViewportScale, wish: number | null | undefined): void {
  if (typeof wish === 'number' && wish > 0) scale.requested = Math.min(wish, 1);
}

/** The part of `full` that the page draws into in this frame: the first question of a frame settles it. */
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

/** What a device does with a scaled viewport: it fills the whole of it, in place. RGBA, rows from the bottom, `widthPx` wide. */
export function stretchViewport(rgba: Uint8Array, widthPx: number, full: ViewportPx, scale: ViewportScale): void {
  const part = partOf(scale, full);
  if (part.widthPx === full.widthPx && part.heightPx === full.heightPx) return;
  // From the far corner, so that no pixel is overwritten before it is read.
  for (let row = full.heightPx - 1; row >= 0; row--) {
    const fromRow = full.y + Math.floor((row * part.heightPx) / full.heightPx);
    for (let column = full.widthPx - 1; column >= 0; column--) {
      const from = (fromRow * widthPx + full.x + Math.floor((column * part.widthPx) / full.widthPx)) * 4;
      rgba.copyWithin(((full.y + row) * widthPx + full.x + column) * 4, from, from + 4);
    }
  }
}
