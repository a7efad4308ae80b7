export interface CanvasFitter {
  /** To be called between frames: setting a canvas's size clears it. */
  update(): void;
  dispose(): void;
}

/** Sharper than two device pixels per CSS pixel shows on no phone, and costs the square. */
const MAX_PIXEL_RATIO = 2;

/** Keeps the drawing buffer as large as the canvas is shown, in device pixels. */
export function createCanvasFitter(canvas: HTMLCanvasElement, maxPixelRatio = MAX_PIXEL_RATIO): CanvasFitter {
  const window = canvas.ownerDocument.defaultView;
  let changed = true;
  const observer = new ResizeObserver(() => {
    changed = true;
  });
  observer.observe(canvas);
  let pixelRatio = 0;
  return {
    update: () => {
      // Moving a window to another screen changes the ratio and no size, so nothing is observed.
      const ratio = Math.min(window?.devicePixelRatio ?? 1, maxPixelRatio);
      if (!changed && ratio === pixelRatio) return;
      changed = false;
      pixelRatio = ratio;
      const width = Math.round(canvas.clientWidth * ratio);
      const height = Math.round(canvas.clientHeight * ratio);
      if (canvas.width !== width) canvas.width = width;
      if (canvas.height !== height) canvas.height = height;
    },
    dispose: () => observer.disconnect(),
  };
}
