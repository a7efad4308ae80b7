import { allocateTexture } from '../../gl/allocate-texture.ts';
import { prepareUpload } from '../../gl/upload.ts';
import type { MutableRoomDepth } from '../session-frame.ts';
import { setDepthUv } from './depth-uv.ts';

/** Converts the room depth of one view from an array of the browser to a texture. */
export interface CpuDepth {
  update(info: XRCPUDepthInformation, format: XRDepthDataFormat, worldFromView: Float32Array): MutableRoomDepth;
  dispose(): void;
}

export function createCpuDepth(gl: WebGL2RenderingContext): CpuDepth {
  let texture: WebGLTexture | null = null;
  let meters = new Float32Array(0);
  let depth: MutableRoomDepth | null = null;
  const resize = (widthPx: number, heightPx: number): MutableRoomDepth => {
    gl.deleteTexture(texture);
    texture = allocateTexture(gl, gl.createTexture(), gl.R32F, gl.NEAREST, widthPx, heightPx);
    meters = new Float32Array(widthPx * heightPx);
    return { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(9), worldFromDepth: new Float32Array(16), meters };
  };
  return {
    update: (info, format, worldFromView) => {
      const { width, height, data, rawValueToMeters } = info;
      if (depth?.widthPx !== width || depth.heightPx !== height) depth = resize(width, height);
      const raw = format === 'float32' ? new Float32Array(data) : new Uint16Array(data);
      for (let i = 0; i < meters.length; i++) {
        const m = (raw[i] ?? 0) * rawValueToMeters;
        // Some runtimes store infinity or NaN where depth is unknown.
        meters[i] = m > 0 && m < Number.POSITIVE_INFINITY ? m : 0;
      }
      prepareUpload(gl, 4);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, depth.texture);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED, gl.FLOAT, meters);
      setDepthUv(depth.uvFromViewUv, info.normDepthBufferFromNormView.matrix, 'top');
      depth.worldFromDepth.set(info.transform?.matrix ?? worldFromView);
      return depth;
    },
    dispose: () => gl.deleteTexture(texture),
  };
}
