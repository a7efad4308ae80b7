/** A PNG with a square image. */
export interface SizedPng {
  readonly sizePx: number;
  readonly bytes: Uint8Array;
}

/**
 * Windows' icon file with PNGs in it, which it reads since Vista (MS "ICONDIR": 6 bytes, then 16 for each picture). 256 is
 * written as 0.
 */
export function icoOf(pictures: readonly SizedPng[]): Uint8Array {
  const head = Buffer.alloc(6 + 16 * pictures.length);
  head.writeUInt16LE(1, 2);
  head.writeUInt16LE(pictures.length, 4);
  let offset = head.length;
  for (const [i, { sizePx, bytes }] of pictures.entries()) {
    const at = 6 + 16 * i;
    head.writeUInt8(sizePx % 256, at);
    head.writeUInt8(sizePx % 256, at + 1);
    head.writeUInt16LE(1, at + 4);
    head.writeUInt16LE(32, at + 6);
    head.writeUInt32LE(bytes.length, at + 8);
    head.writeUInt32LE(offset, at + 12);
    offset += bytes.length;
  }
  return Buffer.concat([head, ...pictures.map(({ bytes }) => bytes)]);
}

/** Names of PNG entries in Apple's icon file, by size in pixels. */
const ICNS_TYPES: Readonly<Record<number, string>> = { 128: 'ic07', 256: 'ic08', 512: 'ic09', 1024: 'ic10' };

/** Apple's icon file: `icns`, its length, then entries of type, length and PNG; lengths count their own eight bytes. */
export function icnsOf(pictures: readonly SizedPng[]): Uint8Array {
  const entries = pictures.map(({ sizePx, bytes }) => {
    const type = ICNS_TYPES[sizePx];
    if (type === undefined) throw new Error(`An icns file has no picture of ${sizePx} pixels.`);
    return Buffer.concat([entryHead(type, bytes.length), bytes]);
  });
  return Buffer.concat([
    entryHead(
      'icns',
      entries.reduce((sum, { length }) => sum + length, 0),
    ),
    ...entries,
  ]);
}

function entryHead(type: string, length: number): Buffer {
  const head = Buffer.alloc(8);
  head.write(type, 'latin1');
  head.writeUInt32BE(8 + length, 4);
  return head;
}
