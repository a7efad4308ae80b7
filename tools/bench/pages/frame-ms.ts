/** The context and draw function of a measured page. */
export interface Drawn {
  readonly gl: WebGLRenderingContext | WebGL2RenderingContext;
  draw(deltaS: number): void;
}

/** Milliseconds per frame over `count` frames, the GPU's work included: reading a pixel waits for it. */
export function measureFrames({ gl, draw }: Drawn, count: number): number {
  const pixel = new Uint8Array(4);
  const startMs = performance.now();
  for (let i = 0; i < count; i++) {
    draw(1 / 60);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  }
  return (performance.now() - startMs) / count;
}

/** The color of a pixel after a frame, RGBA. Origin bottom left. */
export function drawnPixel({ gl, draw }: Drawn, x: number, y: number): number[] {
  draw(1 / 60);
  const pixel = new Uint8Array(4);
  gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  return [...pixel];
}

/** The colors of pixels after one frame, RGBA. Origin bottom left. */
export function drawnPixels({ gl, draw }: Drawn, places: readonly (readonly [x: number, y: number])[]): number[][] {
  draw(1 / 60);
  const pixel = new Uint8Array(4);
  return places.map(([x, y]) => {
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return [...pixel];
  });
}
