import { borrowGl, type Gl, isWebGl2 } from '../display/app-gl.ts';
import { clearFramebuffer } from '../display/clear-framebuffer.ts';

/** The textures of one composition layer in the page's context. */
export interface LayerImages {
  readonly color: WebGLTexture;
  readonly depthStencil: WebGLTexture | null;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Layers of the texture array; 0 for a plain texture. */
  readonly arrayLength: number;
  /** Clears all images to transparent black and far depth. */
  clear(): void;
  /** Reads one array layer as premultiplied RGBA, rows from the bottom. */
  read(index: number, out: Uint8Array): void;
  dispose(): void;
}

export interface LayerImagesOptions {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly arrayLength: number;
  readonly colorFormat: GLenum;
  /** 0 for a layer without depth. */
  readonly depthFormat: GLenum;
}

/** Color formats of WebXR Layers §5.1 that can be drawn to, with their sized formats. */
const COLOR_FORMATS: ReadonlyMap<GLenum, GLenum> = new Map([
  [0x1908, 0x8058], // RGBA: RGBA8
  [0x1907, 0x8051], // RGB: RGB8
  [0x8058, 0x8058], // RGBA8
  [0x8051, 0x8051], // RGB8
  [0x8c43, 0x8c43], // SRGB8_ALPHA8
]);

/** Depth formats with their sized format and whether it has a stencil. */
const DEPTH_FORMATS: ReadonlyMap<GLenum, readonly [sized: GLenum, stencil: boolean]> = new Map([
  [0x1902, [0x81a6, false]], // DEPTH_COMPONENT: DEPTH_COMPONENT24
  [0x81a6, [0x81a6, false]], // DEPTH_COMPONENT24
  [0x84f9, [0x88f0, true]], // DEPTH_STENCIL: DEPTH24_STENCIL8
  [0x88f0, [0x88f0, true]], // DEPTH24_STENCIL8
]);

/** @throws TypeError if the context does not support the format or the size. */
export function createLayerImages(gl: Gl, options: LayerImagesOptions): LayerImages {
  const { widthPx, heightPx, arrayLength, colorFormat, depthFormat } = options;
  checkFormats(gl, options);
  const framebuffer = gl.createFramebuffer();
  const attach = (attachment: GLenum, texture: WebGLTexture | null, index: number): void => {
    if (arrayLength > 0 && isWebGl2(gl)) gl.framebufferTextureLayer(gl.FRAMEBUFFER, attachment, texture, 0, index);
    else gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
  };
  const [color, depthStencil] = borrowGl(gl, () => [
    isWebGl2(gl) ? sizedTexture(gl, options, COLOR_FORMATS.get(colorFormat) ?? gl.RGBA8) : plainTexture(gl, options, colorFormat),
    depthTexture(gl, options),
  ]);
  const depthAttachment = DEPTH_FORMATS.get(depthFormat)?.[1] ? gl.DEPTH_STENCIL_ATTACHMENT : gl.DEPTH_ATTACHMENT;
  const bind = (index: number): void => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    attach(gl.COLOR_ATTACHMENT0, color, index);
    if (depthStencil) attach(depthAttachment, depthStencil, index);
  };
  return {
    color,
    depthStencil,
    widthPx,
    heightPx,
    arrayLength,
    clear: () => {
      if (gl.isContextLost()) return;
      borrowGl(gl, () => {
        for (let index = 0; index < Math.max(1, arrayLength); index++) {
          bind(index);
          clearFramebuffer(gl);
        }
      });
    },
    read: (index, out) => {
      if (gl.isContextLost()) {
        out.fill(0);
        return;
      }
      borrowGl(gl, () => {
        bind(index);
        gl.readPixels(0, 0, widthPx, heightPx, gl.RGBA, gl.UNSIGNED_BYTE, out);
      });
    },
    dispose: () => {
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(color);
      gl.deleteTexture(depthStencil);
    },
  };
}

function checkFormats(gl: Gl, { arrayLength, colorFormat, depthFormat, widthPx, heightPx }: LayerImagesOptions): void {
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
  if (Math.max(widthPx, heightPx) > most)
    throw new TypeError(`A layer of ${widthPx} × ${heightPx} pixels is too large. The limit is ${most}.`);
  const sizedOnly = colorFormat !== gl.RGBA && colorFormat !== gl.RGB;
  if (!COLOR_FORMATS.has(colorFormat) || (sizedOnly && !isWebGl2(gl))) {
    throw new TypeError(`The color format 0x${colorFormat.toString(16)} is not supported by this context.`);
  }
  if (depthFormat !== 0 && !DEPTH_FORMATS.has(depthFormat)) {
    throw new TypeError(`The depth format 0x${depthFormat.toString(16)} is not supported for layers.`);
  }
  if (arrayLength > 0 && !isWebGl2(gl)) throw new TypeError('Texture arrays require WebGL 2.');
}

function sizedTexture(gl: WebGL2RenderingContext, { widthPx, heightPx, arrayLength }: LayerImagesOptions, format: GLenum): WebGLTexture {
  const target = arrayLength > 0 ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
  const texture = gl.createTexture();
  gl.bindTexture(target, texture);
  if (arrayLength > 0) gl.texStorage3D(target, 1, format, widthPx, heightPx, arrayLength);
  else gl.texStorage2D(target, 1, format, widthPx, heightPx);
  sampleNearest(gl, target);
  return texture;
}

function plainTexture(gl: Gl, { widthPx, heightPx }: LayerImagesOptions, format: GLenum, type: GLenum = gl.UNSIGNED_BYTE): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, format, widthPx, heightPx, 0, format, type, null);
  sampleNearest(gl, gl.TEXTURE_2D);
  return texture;
}

/**
 * Creates the depth texture of a layer. Null without a depth format, and in WebGL 1 without depth textures, as the specification permits.
 */
function depthTexture(gl: Gl, options: LayerImagesOptions): WebGLTexture | null {
  const found = DEPTH_FORMATS.get(options.depthFormat);
  if (!found) return null;
  if (isWebGl2(gl)) return sizedTexture(gl, options, found[0]);
  const extension = gl.getExtension('WEBGL_depth_texture');
  if (!extension) return null;
  return found[1]
    ? plainTexture(gl, options, gl.DEPTH_STENCIL, extension.UNSIGNED_INT_24_8_WEBGL)
    : plainTexture(gl, options, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT);
}

function sampleNearest(gl: Gl, target: GLenum): void {
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(target, name, gl.CLAMP_TO_EDGE);
}
