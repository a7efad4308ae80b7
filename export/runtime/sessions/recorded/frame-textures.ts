import { allocateTexture } from '../../gl/allocate-texture.ts';
import { prepareUpload } from '../../gl/upload.ts';
import type { SessionFile } from '../session-format.ts';
import type { DecodedFrame } from './frame-cache.ts';

/** Textures of the current frame. First rows are top rows, so the UV matrices flip them. */
export interface FrameTextures {
  readonly color: WebGLTexture;
  /** Room depth in meters (R32F); null if the recording has no depth. */
  readonly depth: WebGLTexture | null;
  upload(frame: DecodedFrame): void;
  dispose(): void;
}

export function createFrameTextures(gl: WebGL2RenderingContext, session: SessionFile): FrameTextures {
  const color = allocateTexture(gl, gl.createTexture(), gl.RGBA8, gl.LINEAR, session.color.widthPx, session.color.heightPx);
  const depth = session.depth
    ? allocateTexture(gl, gl.createTexture(), gl.R32F, gl.NEAREST, session.depth.widthPx, session.depth.heightPx)
    : null;
  return {
    color,
    depth,
    upload: (frame) => {
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, color);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl.RGBA, gl.UNSIGNED_BYTE, frame.color);
      if (!depth || !session.depth || !frame.meters) return;
      gl.bindTexture(gl.TEXTURE_2D, depth);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, session.depth.widthPx, session.depth.heightPx, gl.RED, gl.FLOAT, frame.meters);
    },
    dispose: () => {
      gl.deleteTexture(color);
      gl.deleteTexture(depth);
    },
  };
}
