/** A problem of a panorama. The message has problem and remedy and follows “cannot be decoded: ”. */
export class PanoramaError extends Error {}

export interface RadianceHeader {
  readonly format: 'hdr' | 'exr';
  readonly widthPx: number;
  readonly heightPx: number;
  /** Offset of the pixels in an HDR file. */
  readonly start: number;
}

const EXR_MAGIC = 0x01312f76;

/**
 * Reads the size from the header of a Radiance HDR (G. Ward, “RADIANCE file formats”) or OpenEXR file (openexr.com, “OpenEXR File Layout”);
 * null for other files. The size must be checked before decoding, because three.js' loaders allocate memory for it.
 *
 * @throws PanoramaError if the header is damaged.
 */
export function readRadianceHeader(bytes: ArrayBuffer): RadianceHeader | null {
  const view = new DataView(bytes);
  if (bytes.byteLength >= 4 && view.getUint32(0, true) === EXR_MAGIC) return readExrHeader(view);
  const isHdr = bytes.byteLength >= 2 && view.getUint16(0) === 0x233f; // #?
  return isHdr ? readHdrHeader(new Uint8Array(bytes)) : null;
}

/** Maximum size of a header, which is a few lines of text. */
const MAX_HDR_HEADER = 8192;

function readHdrHeader(bytes: Uint8Array): RadianceHeader {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, MAX_HDR_HEADER));
  const size = /\n([-+][XY]) +(\d+) +([-+][XY]) +(\d+)\n/.exec(head);
  if (!size) throw new PanoramaError('its beginning names no size. Export it again');
  if (size[1] !== '-Y' || size[3] !== '+X') {
    throw new PanoramaError('its rows are not stored from the top left. Open it in another program and save it again');
  }
  return { format: 'hdr', widthPx: Number(size[4]), heightPx: Number(size[2]), start: size.index + size[0].length };
}

/**
 * Whether an HDR file is truncated. three.js' loader would read missing pixels as black. Rows are run-length encoded per channel, or plain
 * pixels of four bytes.
 */
export function isCutOff(file: ArrayBuffer, { format, widthPx, heightPx, start }: RadianceHeader): boolean {
  if (format !== 'hdr') return false;
  const bytes = new Uint8Array(file);
  const inRuns = widthPx >= 8 && widthPx < 0x8000 && bytes[start] === 2 && bytes[start + 1] === 2 && (bytes[start + 2] ?? 0) < 0x80;
  if (!inRuns) return bytes.length - start < widthPx * heightPx * 4;
  let at = start;
  for (let y = 0; y < heightPx; y++) {
    at += 4;
    for (let left = widthPx * 4; left > 0; ) {
      const count = bytes[at] ?? 0;
      // An empty run is damage, which the loader reports.
      if (count === 0) return at >= bytes.length;
      left -= count > 128 ? count - 128 : count;
      at += count > 128 ? 2 : count + 1;
    }
  }
  return at > bytes.length;
}

/**
 * Reads the header of an OpenEXR file: after the magic number a byte with the version, three bytes of flags, then attributes of name, type,
 * size and value.
 */
function readExrHeader(view: DataView): RadianceHeader {
  try {
    for (let at = 8; view.getUint8(at) !== 0; ) {
      const name = readText(view, at);
      const type = readText(view, at + name.length + 1);
      const size = at + name.length + type.length + 2;
      const value = size + 4;
      if (name === 'dataWindow') {
        const [minX, minY, maxX, maxY] = [0, 4, 8, 12].map((offset) => view.getInt32(value + offset, true)) as [
          number,
          number,
          number,
          number,
        ];
        return { format: 'exr', widthPx: maxX - minX + 1, heightPx: maxY - minY + 1, start: 0 };
      }
      at = value + view.getInt32(size, true);
    }
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
  }
  throw new PanoramaError('its beginning names no size. Export it again');
}

function readText(view: DataView, start: number): string {
  let text = '';
  for (let at = start; view.getUint8(at) !== 0; at++) text += String.fromCharCode(view.getUint8(at));
  return text;
}
