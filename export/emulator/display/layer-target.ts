import type { Gl } from './app-gl.ts';

/**
 * The framebuffer that the device provides to a page. It is not the canvas, so pages that draw to the canvas by mistake show nothing, as on
 * a device.
 */
export interface LayerTarget {
  /** Null for the canvas, as in inline sessions. */
  readonly framebuffer: WebGLFramebuffer | null;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Resizes and clears; the framebuffer object stays the same. */
  resize(widthPx: number, heightPx: number): void;
  /** Clears to transparent black and far depth, as at the start of every frame (WebXR Device API §11.2). */
  clear(): void;
  /** Reads the image into `out`: premultiplied RGBA, rows from the bottom. */
  read(out: Uint8Array): void;
  dispose(): void;
}

export interface LayerTargetOptions {
  readonly antialias: boolean;
  readonly depth: boolean;
  readonly stencil: boolean;
  readonly alpha: boolean;
}

/**
 * Creates the target of an inline session, whose page draws to its own canvas: `resize` and `clear` do nothing, and `read` returns
 * transparent black.
 */
export function canvasTarget(gl: Gl): LayerTarget {
  return {
    framebuffer: null,
    get widthPx() {
      return gl.drawingBufferWidth;
    },
    get heightPx() {
      return gl.drawingBufferHeight;
    },
    resize: () => {},
    clear: () => {},
    read: (out) => void out.fill(0),
    dispose: () => {},
  };
}
