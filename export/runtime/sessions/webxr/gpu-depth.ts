import { setPassState, setSampler } from '../../../../nodes/kit/pass-state.ts';
import { allocateTexture } from '../../gl/allocate-texture.ts';
import type { MutableRoomDepth } from '../session-frame.ts';
import { createDecoder, type DepthDecoder, type DepthSource } from './depth-decoder.ts';
import { setDepthUv } from './depth-uv.ts';
import type { XrGpuDepthInformation } from './webxr-types.ts';

/** GPU depth of one view, decoded to meters once per frame, so that all readers get the same format. */
export interface GpuDepth {
  /** Decodes the depth of this frame; null if the browser has no valid depth. */
  update(info: XrGpuDepthInformation, format: XRDepthDataFormat, worldFromView: Float32Array): MutableRoomDepth | null;
  dispose(): void;
}

/** Creates the depth of the device's view `viewIndex`. Returns null if the GPU cannot render to float textures. */
export function createGpuDepth(gl: WebGL2RenderingContext, viewIndex: number): GpuDepth | null {
  // Half floats resolve 1 mm at 1 m and 4 mm at 4 m, about the precision of the sensors.
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
      // Browsers that do not report the type use an array with a layer per view, as Quest Browser does.
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
