import { NodeBasisEncoder } from 'ktx2-encoder';

export interface Ktx2Options {
  readonly mimeType: 'image/png' | 'image/jpeg';
  /** Colors for the eye, not numbers. */
  readonly srgb: boolean;
  readonly normals: boolean;
}

/** `ldr_image_type` of Basis Universal's wrapper (`webgl/transcoder/basis_wrappers.cpp`), which decodes the files itself. */
const FILE_TYPE = { 'image/png': 1, 'image/jpeg': 2 } as const;

/** Effort 1 of 4: at least 48 dB on photographs and drawings, in 1.8 s a million pixels; 2 takes thrice as long for 1 dB more. */
const EFFORT = 1;

/** Basis Universal's encoder is opened once, and keeps some megabytes. */
const encoders = new NodeBasisEncoder();

/**
 * A PNG or JPEG file as KTX2: UASTC with mip maps, packed with Zstandard. The same picture gives the same bytes. Null where the
 * encoder cannot read the picture.
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
    // A byte a pixel, a third more for mip maps, and headers: packed it is hardly ever that much.
    const out = new Uint8Array(image.length * 2 + OUT_BYTES);
    const length = encoder.encode(out);
    return length === 0 ? null : out.slice(0, length);
  } finally {
    encoder.delete();
  }
}

/** Of the largest picture that is encoded: 12 Mi pixels of a byte, with mip maps. */
const OUT_BYTES = 17 * 2 ** 20;
