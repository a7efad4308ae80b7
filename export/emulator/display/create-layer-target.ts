import { borrowGl, type Gl, isWebGl2 } from './app-gl.ts';
import { clearFramebuffer } from './clear-framebuffer.ts';
import { createWebGl1Storage, createWebGl2Storage } from './layer-storage.ts';
import type { LayerTarget, LayerTargetOptions } from './layer-target.ts';

/** Creates the device's framebuffer in the page's WebGL 1 or 2 context. */
export function createLayerTarget(gl: Gl, startWidthPx: number, startHeightPx: number, options: LayerTargetOptions): LayerTarget {
  const storage = isWebGl2(gl) ? createWebGl2Storage(gl, options) : createWebGl1Storage(gl, options);
  const { framebuffer } = storage;
  let widthPx = startWidthPx;
  let heightPx = startHeightPx;
  const allocate = (): void => storage.allocate(widthPx, heightPx);
  borrowGl(gl, allocate);

  /** Whether the framebuffer is lost with its context. It stays lost when the context is restored: the page creates a new layer. */
  const isGone = (): boolean => gl.isContextLost() || !gl.isFramebuffer(framebuffer);

  return {
    framebuffer,
    get widthPx() {
      return widthPx;
    },
    get heightPx() {
      return heightPx;
    },
    resize: (toWidthPx, toHeightPx) => {
      if (isGone()) return;
      widthPx = toWidthPx;
      heightPx = toHeightPx;
      borrowGl(gl, allocate);
    },
    clear: () => {
      if (isGone()) return;
      borrowGl(gl, () => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        clearFramebuffer(gl);
      });
    },
    read: (out) => {
      if (isGone()) {
        out.fill(0);
        return;
      }
      borrowGl(gl, () => {
        storage.bindForReading(widthPx, heightPx);
        gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, out);
      });
    },
    dispose: storage.dispose,
  };
}
