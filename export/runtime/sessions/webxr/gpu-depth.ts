import { setPassState, setSampler } from '../../../../nodes/kit/pass-state.ts';
import { allocateTexture } from '../../gl/allocate-texture.ts';
import type { MutableRoomDepth } from '../session-frame.ts';
import { createDecoder, type DepthDecoder, type DepthSource } from './depth-decoder.ts';
import { setDepthUv } from './depth-uv.ts';
import type { XrGpuDepthInformation } from './webxr-types.ts';

/** Depth that stays on the GPU, for one view: decoded to meters once a frame, so that all who read it find one format. */
export interface GpuDepth {
  /** Null while the browser has no valid depth. */
  update(info: XrGpuDepthInformation, format: XRDepthDataFormat, worldFromView: Float32Array): MutableRoomDepth | null;
  dispose(): void;
}

/** `viewIndex`: which view of the device it is for. Null where the GPU can draw no floats at all. */
export function createGpuDepth(gl: WebGL2RenderingContext, viewIndex: number): GpuDepth | null {
  // Half floats keep a millimeter at 1 m and four at 4 m, about what the sensors do.
  const format = gl.getExtension('EXT_color_buffer_float') ? gl.R32F : gl.getExtension('EXT_color_buffer_half_float') ? gl.R16F : null;
  if (format === null) return null;
  const framebuffer = gl.createFramebuffer();
  const vertexArray = gl.createVertexArray();
  const sampler = gl.createSampler();
  setSampler(gl, sampler, gl.NEAREST);
  let decoder: DepthDecoder | null = null;
  let depth: MutableRoomDepth | null = null;

  const resize = (widthPx: number, heightPx: number): MutableRoomDepth => {
    gl.deleteTexture(depth?.texture ?? null);
    const texture = allocateTexture(gl, gl.createTexture(), format, gl.NEAREST, widthPx, heightPx);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    return { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(9), worldFromDepth: new Float32Array(16) };
  };
  return {
    update: (info, dataFormat, worldFromView) => {
      if (info.isValid === false) return null;
      const { width, height } = info;
      if (depth?.widthPx !== width || depth.heightPx !== height) depth = resize(width, height);
      const source = sourceOf(info, dataFormat);
      // Browsers that do not say give an array with a layer per view, as Quest Browser does.
      const array = info.textureType !== 'texture';
      if (decoder?.source !== source || decoder.array !== array) {
        decoder?.dispose();
        decoder = createDecoder(gl, source, array);
      }
      setPassState(gl, framebuffer, vertexArray, 0, 0, width, height);
      decoder.use(info, viewIndex);
      gl.bindSampler(0, sampler);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      gl.bindSampler(0, null);
      gl.bindVertexArray(null);
      setDepthUv(depth.uvFromViewUv, info.normDepthBufferFromNormView.matrix, source === 'window' ? 'bottom' : 'top');
      depth.worldFromDepth.set(info.transform?.matrix ?? worldFromView);
      return depth;
    },
    dispose: () => {
      decoder?.dispose();
      gl.deleteTexture(depth?.texture ?? null);
      gl.deleteFramebuffer(framebuffer);
      gl.deleteVertexArray(vertexArray);
      gl.deleteSampler(sampler);
    },
  };
}

function sourceOf(info: XrGpuDepthInformation, format: XRDepthDataFormat): DepthSource {
  return info.depthNear ? 'window' : format;
}
