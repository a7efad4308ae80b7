/** Bytes that are decoded at a time: a string in memory has at most half a gigabyte, and files may have more. */
const CHUNK_BYTES = 2 ** 22;

/**
 * The lines of a text file, without their ends. Only a part of the file is in memory as text, so a reader that stops early, as at a limit,
 * costs as little as what it has read.
 *
 * @param start Byte at which the first line begins.
 */
export function* linesOf(bytes: Uint8Array, start = 0): Generator<string, void> {
  const decoder = new TextDecoder();
  let rest = '';
  for (let at = start; at < bytes.length; at += CHUNK_BYTES) {
    const lines = (rest + decoder.decode(bytes.subarray(at, at + CHUNK_BYTES), { stream: true })).split(/\r?\n/);
    rest = lines.pop() ?? '';
    yield* lines;
  }
  yield rest + decoder.decode();
}
