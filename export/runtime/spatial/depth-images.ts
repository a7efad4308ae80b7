import type { RoomDepth, SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import { createPixelReadback } from '../gl/pixel-readback.ts';
import { prepareReadback } from '../gl/upload.ts';
import { MAX_VIEWS } from '../targets/target.ts';
import type { DepthImage } from './cast/cast-depth.ts';

/** Provides the room depth of each view on the CPU. Depth is read back only if it is requested. */
export interface DepthImages {
  /**
   * Returns the depth of a view.
   *
   * @param frame The current frame.
   * @returns The depth of this frame if the session has it on the CPU; else the depth that was last read back from the GPU, with the view
   * for which it was measured. Null while there is none.
   */
  image(frame: SessionFrame, viewIndex: number): DepthImage | null;
  /** Drops the GPU objects, which are lost with the context. */
  contextLost(): void;
  dispose(): void;
}

/**
 * Creates the depth images. With `held`, each frame waits for its own depth, so that renders repeat; otherwise nothing waits for the GPU.
 */
export function createDepthImages(gl: WebGL2RenderingContext, held: boolean): DepthImages {
  const views = Array.from({ length: MAX_VIEWS }, () => createReading(gl, held));
  return {
    image: (frame, index) => {
      const view = index < frame.viewCount ? frame.views[index] : null;
      return (view && views[index]?.image(frame, view)) ?? null;
    },
    contextLost: () => {
      for (const view of views) view.forget();
    },
    dispose: () => {
      for (const view of views) view.dispose();
    },
  };
}

interface Reading {
  image(frame: SessionFrame, view: ViewFrame): DepthImage | null;
  forget(): void;
  dispose(): void;
}

type MutableDepthImage = DepthImage & { rgba: Float32Array };

function createReading(gl: WebGL2RenderingContext, held: boolean): Reading {
  /** The image that readers get; `coming` is being read back, and then the two are exchanged. */
  let shown = createImage();
  let coming = createImage();
  let hasShown = false;
  let framebuffer: WebGLFramebuffer | null = null;
  const readback = createPixelReadback(gl);
  let askedFrame = -1;
  let askedS = -1;

  function describe(image: MutableDepthImage, frame: SessionFrame, view: ViewFrame, depth: RoomDepth): void {
    image.widthPx = depth.widthPx;
    image.heightPx = depth.heightPx;
    image.uvFromViewUv.set(depth.uvFromViewUv);
    image.clipFromView.set(view.clipFromView);
    image.worldFromView.set(depth.worldFromDepth);
    image.frame = frame.index;
  }

  /** Reads depth back from the GPU, without waiting unless `held`. Returns false if the GPU does not support reading floats. */
  function read(image: MutableDepthImage, depth: RoomDepth): boolean {
    framebuffer ??= gl.createFramebuffer();
    const count = depth.widthPx * depth.heightPx;
    if (image.rgba.length !== 4 * count) {
      image.rgba = new Float32Array(4 * count);
      image.meters = new Float32Array(count);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, depth.texture, 0);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      return false;
    }
    if (held) {
      prepareReadback(gl);
      gl.readPixels(0, 0, depth.widthPx, depth.heightPx, gl.RGBA, gl.FLOAT, image.rgba);
    } else {
      readback.start(depth.widthPx, depth.heightPx, 'floats');
    }
    // The session's texture is not kept alive by this framebuffer.
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, null, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return true;
  }

  function show(): void {
    for (let i = 0; i < coming.meters.length; i++) coming.meters[i] = coming.rgba[4 * i] ?? 0;
    [shown, coming] = [coming, shown];
    hasShown = true;
  }

  const comingRgba = (): Float32Array => coming.rgba;

  function collect(): void {
    if (readback.collect(comingRgba, false)) show();
  }

  function readBack(frame: SessionFrame, view: ViewFrame, depth: RoomDepth): void {
    collect();
    if (readback.isReading || !read(coming, depth)) return;
    describe(coming, frame, view, depth);
    if (held) show();
  }

  const forget = (): void => {
    framebuffer = null;
    // Objects that were lost with the context are ignored.
    readback.dispose();
    hasShown = false;
  };
  return {
    image: (frame, view) => {
      const { depth } = view;
      if (!depth) {
        hasShown = false;
        return null;
      }
      if (frame.index === askedFrame && frame.timeS === askedS) return hasShown ? shown : null;
      askedFrame = frame.index;
      askedS = frame.timeS;
      if (depth.meters) {
        describe(shown, frame, view, depth);
        shown.meters = depth.meters;
        shown.rgba = NONE;
        hasShown = true;
      } else readBack(frame, view, depth);
      return hasShown ? shown : null;
    },
    forget,
    dispose: () => {
      if (framebuffer) gl.deleteFramebuffer(framebuffer);
      forget();
    },
  };
}

const NONE = new Float32Array(0);

function createImage(): MutableDepthImage {
  return {
    meters: NONE,
    rgba: NONE,
    widthPx: 0,
    heightPx: 0,
    uvFromViewUv: new Float32Array(9),
    clipFromView: new Float32Array(16),
    worldFromView: new Float32Array(16),
    frame: 0,
  };
}
