export interface WebmFrame {
  readonly timeMs: number;
  readonly key: boolean;
  readonly data: Uint8Array;
  /** Alpha of a transparent video, as the luminance of a second video. */
  readonly alpha?: Uint8Array;
}

export interface WebmVideo {
  readonly codec: 'V_VP8' | 'V_VP9';
  readonly widthPx: number;
  readonly heightPx: number;
  /** Null: the file does not state its duration, as in browser recordings. */
  readonly durationMs: number | null;
  /** Frames in order; the first is a key frame. */
  readonly frames: readonly WebmFrame[];
}

/**
 * A WebM file of one silent video (RFC 9559, "Matroska"): one cluster per key frame, with cues, so that it can be sought; alpha as
 * the WebM project's "Alpha transparency" guide has it. Files of equal frames are equal.
 */
export function writeWebm({ codec, widthPx, heightPx, durationMs, frames }: WebmVideo): Uint8Array<ArrayBuffer> {
  const hasAlpha = frames.some(({ alpha }) => alpha !== undefined);
  const info = element(0x1549a966, [
    element(0x2ad7b1, uint(1_000_000)),
    ...(durationMs === null ? [] : [element(0x4489, float(durationMs))]),
    element(0x4d80, text('Scrim')),
    element(0x5741, text('Scrim')),
  ]);
  const track = element(0xae, [
    element(0xd7, uint(1)),
    element(0x73c5, uint(1)),
    element(0x9c, uint(0)),
    element(0x83, uint(1)),
    element(0x86, text(codec)),
    ...(hasAlpha ? [element(0x55ee, uint(1))] : []),
    element(0xe0, [element(0xb0, uint(widthPx)), element(0xba, uint(heightPx)), ...(hasAlpha ? [element(0x53c0, uint(1))] : [])]),
  ]);
  const tracks = element(0x1654ae6b, [track]);
  const clusters = clustersOf(frames);
  const cues: Uint8Array[] = [];
  let at = info.length + tracks.length;
  for (const { timeMs, bytes } of clusters) {
    cues.push(element(0xbb, [element(0xb3, uint(timeMs)), element(0xb7, [element(0xf7, uint(1)), element(0xf1, uint(at))])]));
    at += bytes.length;
  }
  const head = element(0x1a45dfa3, [
    element(0x4286, uint(1)),
    element(0x42f7, uint(1)),
    element(0x42f2, uint(4)),
    element(0x42f3, uint(8)),
    element(0x4282, text('webm')),
    element(0x4287, uint(4)),
    element(0x4285, uint(2)),
  ]);
  const segment = element(0x18538067, [info, tracks, ...clusters.map(({ bytes }) => bytes), element(0x1c53bb6b, cues)]);
  return join([head, segment]);
}

function clustersOf(frames: readonly WebmFrame[]): readonly { readonly timeMs: number; readonly bytes: Uint8Array }[] {
  const groups: WebmFrame[][] = [];
  for (const frame of frames) {
    if (frame.key) groups.push([frame]);
    else groups.at(-1)?.push(frame);
  }
  return groups.map((group) => {
    const timeMs = group[0]?.timeMs ?? 0;
    const blocks = group.map((frame, i) => blockOf(frame, timeMs, frame.timeMs - (group[i - 1]?.timeMs ?? 0)));
    return { timeMs, bytes: element(0x1f43b675, [element(0xe7, uint(timeMs)), ...blocks]) };
  });
}

function blockOf({ timeMs, key, data, alpha }: WebmFrame, clusterMs: number, sinceLastMs: number): Uint8Array {
  const sinceMs = timeMs - clusterMs;
  const head = [0x81, (sinceMs >> 8) & 0xff, sinceMs & 0xff];
  if (!alpha) return element(0xa3, join([Uint8Array.of(...head, key ? 0x80 : 0), data]));
  const addition = element(0x75a1, [element(0xa6, [element(0xee, uint(1)), element(0xa5, alpha)])]);
  return element(0xa0, [
    element(0xa1, join([Uint8Array.of(...head, 0), data])),
    addition,
    // A block that references another one is not a key frame.
    ...(key ? [] : [element(0xfb, Uint8Array.of(256 - Math.min(sinceLastMs, 127)))]),
  ]);
}

/** Sizes always take eight bytes, which is simple and wastes little. */
function element(id: number, content: Uint8Array | readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const body = content instanceof Uint8Array ? content : join(content);
  const name: number[] = [];
  for (let rest = id; rest > 0; rest = Math.floor(rest / 256)) name.unshift(rest % 256);
  const size = new DataView(new ArrayBuffer(8));
  size.setBigUint64(0, BigInt(body.length));
  size.setUint8(0, 1);
  return join([Uint8Array.from(name), new Uint8Array(size.buffer), body]);
}

function uint(value: number): Uint8Array {
  const bytes: number[] = [];
  for (let rest = value; rest > 0 || bytes.length === 0; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  return Uint8Array.from(bytes);
}

function float(value: number): Uint8Array {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return new Uint8Array(view.buffer);
}

function text(value: string): Uint8Array {
  return new TextEncoder().encode(value);
}

function join(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
