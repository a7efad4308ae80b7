export interface ImageSize {
  readonly widthPx: number;
  readonly heightPx: number;
  /** For an image that is compressed for the GPU (KTX2): its number of mip levels. Null for other formats. */
  readonly ktx2: { readonly levels: number } | null;
}

/** Reads the size from the header of a PNG, JPEG, WebP or KTX2 file; null for other and invalid files. */
export function imageSize(bytes: Uint8Array): ImageSize | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    const size = pngSize(view) ?? jpegSize(view) ?? webpSize(view);
    return size ? { widthPx: size[0], heightPx: size[1], ktx2: null } : ktx2Size(view);
  } catch (error) {
    // Read beyond the end: the file is truncated.
    if (error instanceof RangeError) return null;
    throw error;
  }
}

type Size = readonly [widthPx: number, heightPx: number];

/** Size from the header of a PNG file: IHDR is the first chunk (PNG specification, §11.2.2). */
function pngSize(view: DataView): Size | null {
  return view.getUint32(0) === 0x89504e47 ? [view.getUint32(16), view.getUint32(20)] : null;
}

/**
 * Size from the frame header of a JPEG file (ITU T.81, §B.2.2). The frame header is the first segment SOF0 to SOF15 that is not DHT, JPG or
 * DAC.
 */
function jpegSize(view: DataView): Size | null {
  if (view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; ; at += 2 + view.getUint16(at + 2)) {
    const marker = view.getUint16(at);
    if (marker < 0xff00) return null;
    if (marker >= 0xffc0 && marker <= 0xffcf && marker !== 0xffc4 && marker !== 0xffc8 && marker !== 0xffcc) {
      return [view.getUint16(at + 7), view.getUint16(at + 5)];
    }
  }
}

/** Size from the header of a WebP file: lossy, lossless or extended (RFC 9649, §2). */
function webpSize(view: DataView): Size | null {
  if (view.getUint32(0) !== 0x52494646 || view.getUint32(8) !== 0x57454250) return null;
  const uint24 = (at: number) => view.getUint16(at, true) + (view.getUint8(at + 2) << 16);
  switch (view.getUint32(12)) {
    case 0x56503820:
      return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
    case 0x5650384c: {
      const bits = view.getUint32(21, true);
      return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
    }
    case 0x56503858:
      return [uint24(24) + 1, uint24(27) + 1];
    default:
      return null;
  }
}

/** Size and mip levels from the header of a KTX2 file (KTX 2.0, §3). */
function ktx2Size(view: DataView): ImageSize | null {
  if (view.getUint32(0) !== 0xab4b5458 || view.getUint32(4) !== 0x203230bb) return null;
  return { widthPx: view.getUint32(20, true), heightPx: view.getUint32(24, true), ktx2: { levels: view.getUint32(40, true) } };
}
