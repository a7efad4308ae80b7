import { NodeBasisEncoder } from 'ktx2-encoder';

export interface Ktx2Options {
  readonly mimeType: 'image/png' | 'image/jpeg';
  /** Whether the image contains colors (sRGB) instead of data. */
  readonly srgb: boolean;
  readonly normals: boolean;
}

/** `ldr_image_type` of Basis Universal's wrapper (`webgl/transcoder/basis_wrappers.cpp`), which decodes the files itself. */
const FILE_TYPE = { 'image/png': 1, 'image/jpeg': 2 } as const;

/**
 * Effort 1 of 4: at least 48 dB on photographs and drawings, in 1.8 s per million pixels. Effort 2 takes three times as long for 1 dB more.
 */
const EFFORT = 1;

/** Basis Universal's encoder, loaded once; it keeps a few megabytes. */
const encoders = new NodeBasisEncoder();

/**
 * Encodes a PNG or JPEG file as KTX2: UASTC with mipmaps, compressed by Zstandard. The same input gives the same bytes. Returns null if the
 * encoder cannot read the image.
 */
export async function encodeKtx2(image: Uint8Array, { mimeType, srgb, normals }: Ktx2Options): Promise<Uint8Array<ArrayBuffer> | null> {
  const { BasisEncoder } = await encoders.init();
  const encoder = new BasisEncoder();
  try {
    encoder.setDebug(false);
    encoder.setCreateKTX2File(true);
    encoder.setUASTC(true);
    encoder.setPackUASTCFlags(EFFORT);
    encoder.setKTX2UASTCSupercompression(true);
    encoder.setMipGen(true);
    encoder.setPerceptual(srgb);
    encoder.setKTX2AndBasisSRGBTransferFunc?.(srgb);
    if (normals) encoder.setNormalMapPreset?.();
    if (encoder.setSliceSourceImage(0, image, 0, 0, FILE_TYPE[mimeType] as number) === false) return null;
    // One byte per pixel, a third more for mipmaps, and headers; compressed output hardly reaches this size.
    const out = new Uint8Array(image.length * 2 + OUT_BYTES);
    const length = encoder.encode(out);
    return length === 0 ? null : out.slice(0, length);
  } finally {
    encoder.delete();
  }
}

/** Size for the largest image: 12 Mi pixels of one byte, with mipmaps. */
const OUT_BYTES = 17 * 2 ** 20;
