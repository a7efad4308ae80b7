/** Bytes per texel of the used formats. */
const TEXEL_BYTES: Readonly<Record<string, number>> = {
  R8: 1,
  RG8: 2,
  RGB8: 3,
  RGBA8: 4,
  SRGB8: 3,
  SRGB8_ALPHA8: 4,
  R16F: 2,
  RG16F: 4,
  RGBA16F: 8,
  R32F: 4,
  RGBA32F: 16,
  R32UI: 4,
  RGBA32UI: 16,
  R11F_G11F_B10F: 4,
  RGB10_A2: 4,
  DEPTH_COMPONENT16: 2,
  DEPTH_COMPONENT24: 4,
  DEPTH_COMPONENT32F: 4,
  DEPTH24_STENCIL8: 4,
  RGB: 3,
  RGBA: 4,
};

/** The number of texels of an image with mip levels. */
export function mipTexels(levels: number, widthPx: number, heightPx: number): number {
  let sum = 0;
  for (let level = 0; level < levels; level++) sum += Math.max(1, widthPx >> level) * Math.max(1, heightPx >> level);
  return sum;
}

/**
 * The bytes per texel of a format, by its number. Tools count memory with it; pages do not.
 *
 * @throws Error for a format that nothing uses.
 */
export function createTexelBytes(gl: WebGL2RenderingContext): (format: GLenum) => number {
  const names = new Map(Object.keys(TEXEL_BYTES).map((name) => [(gl as unknown as Record<string, number>)[name], name]));
  return (format) => {
    const name = names.get(format);
    if (name === undefined) throw new Error(`The texel size of the format 0x${format.toString(16)} is unknown.`);
    return TEXEL_BYTES[name] ?? 0;
  };
}
