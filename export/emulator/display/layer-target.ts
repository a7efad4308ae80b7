import type { Gl } from './app-gl.ts';

/** The framebuffer that the device lends to a page: its own, never the canvas, so that a page that draws into the canvas shows nothing here either. */
export interface LayerTarget {
  /** Null: the canvas itself, as for sessions on the page. */
  readonly framebuffer: WebGLFramebuffer | null;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Of another size from now on, and empty; the framebuffer stays the same one. */
  resize(widthPx: number, heightPx: number): void;
  /** Transparent black and far depth, as every frame begins (WebXR Device API §11.2). */
  clear(): void;
  /** Premultiplied RGBA, rows from the bottom. */
  read(out: Uint8Array): void;
  dispose(): void;
}

export interface LayerTargetOptions {
  readonly antialias: boolean;
  readonly depth: boolean;
  readonly stencil: boolean;
  readonly alpha: boolean;
}

/** What stands for a framebuffer of the device where a page draws into its canvas: nothing is cleared, scaled or shown elsewhere. */
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
