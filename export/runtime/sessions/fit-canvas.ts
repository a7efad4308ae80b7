export interface CanvasFitter {
  /** Applies a changed size. Call it between frames, because setting the size of a canvas clears it. */
  update(): void;
  dispose(): void;
}

/** Maximum number of device pixels per CSS pixel that are drawn. More are not visible on phones. */
const MAX_PIXEL_RATIO = 2;

/** Keeps the drawing buffer at the size of the canvas on the page, in device pixels. */
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
      // Moving a window to another screen changes the ratio without a resize event, so it is read every frame.
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
