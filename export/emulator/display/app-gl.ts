/** A WebGL context of the page. */
export type Gl = WebGLRenderingContext | WebGL2RenderingContext;

export function isWebGl2(gl: Gl): gl is WebGL2RenderingContext {
  return gl instanceof WebGL2RenderingContext;
}

/**
 * Runs `work` with the page's context and restores the state that uploads and framebuffers change, because a real device does not touch the
 * page's GL state.
 */
export function borrowGl<T>(gl: Gl, work: () => T): T {
  const giveBack = isWebGl2(gl) ? keepWebGl2(gl) : keepFramebuffer(gl);
  const textures = TEXTURE_TARGETS.filter(([target]) => target in gl).map(
    ([target, binding]) => [(gl as WebGL2RenderingContext)[target], gl.getParameter((gl as WebGL2RenderingContext)[binding])] as const,
  );
  const stores = PIXEL_STORES.filter(([name]) => name in gl).map(
    ([name, neutral]) => [(gl as WebGL2RenderingContext)[name], gl.getParameter((gl as WebGL2RenderingContext)[name]), neutral] as const,
  );
  const renderbuffer = gl.getParameter(gl.RENDERBUFFER_BINDING);
  const scissored = gl.isEnabled(gl.SCISSOR_TEST);
  for (const [name, , neutral] of stores) gl.pixelStorei(name, neutral);
  if (scissored) gl.disable(gl.SCISSOR_TEST);
  try {
    return work();
  } finally {
    if (scissored) gl.enable(gl.SCISSOR_TEST);
    for (const [target, texture] of textures) gl.bindTexture(target, texture);
    for (const [name, value] of stores) gl.pixelStorei(name, value);
    gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
    giveBack();
  }
}

function keepFramebuffer(gl: WebGLRenderingContext): () => void {
  const framebuffer = gl.getParameter(gl.FRAMEBUFFER_BINDING);
  return () => gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
}

/** Unbinds the pixel buffers, which would redirect uploads and reads. Returns a function that restores them. */
function keepWebGl2(gl: WebGL2RenderingContext): () => void {
  const unpackBuffer = gl.getParameter(gl.PIXEL_UNPACK_BUFFER_BINDING);
  const packBuffer = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
  const drawFramebuffer = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING);
  const readFramebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
  gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  return () => {
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, unpackBuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, packBuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, drawFramebuffer);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, readFramebuffer);
  };
}

const TEXTURE_TARGETS = [
  ['TEXTURE_2D', 'TEXTURE_BINDING_2D'],
  ['TEXTURE_2D_ARRAY', 'TEXTURE_BINDING_2D_ARRAY'],
  ['TEXTURE_CUBE_MAP', 'TEXTURE_BINDING_CUBE_MAP'],
] as const;

/**
 * Pixel storage parameters with their defaults. The alignment is 1, because rows of 16-bit depth with odd widths are not multiples of 4
 * bytes.
 */
const PIXEL_STORES = [
  ['UNPACK_FLIP_Y_WEBGL', 0],
  ['UNPACK_PREMULTIPLY_ALPHA_WEBGL', 0],
  ['UNPACK_COLORSPACE_CONVERSION_WEBGL', 0],
  ['UNPACK_ALIGNMENT', 1],
  ['UNPACK_ROW_LENGTH', 0],
  ['UNPACK_SKIP_ROWS', 0],
  ['UNPACK_SKIP_PIXELS', 0],
  ['UNPACK_IMAGE_HEIGHT', 0],
  ['UNPACK_SKIP_IMAGES', 0],
  ['PACK_ALIGNMENT', 1],
  ['PACK_ROW_LENGTH', 0],
  ['PACK_SKIP_ROWS', 0],
  ['PACK_SKIP_PIXELS', 0],
] as const;
