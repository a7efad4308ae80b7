/**
 * Media type of the binary encoding of calls to the loopback server: JSON, followed by the raw bytes of top-level `Uint8Array` fields.
 * Base64 would add a third and several copies to a model of 100 MB.
 *
 * Layout: length of the JSON in bytes (32 bits, little endian), the JSON `{ value, blobs: [[field, length], …] }`, the blobs.
 */
export const MESSAGE_TYPE = 'application/vnd.scrim.message';

interface Envelope {
  readonly value: Record<string, unknown>;
  readonly blobs: readonly (readonly [field: string, length: number])[];
}

export function encodeMessage(fields: Readonly<Record<string, unknown>>): Uint8Array<ArrayBuffer> {
  const blobs = Object.entries(fields).filter((entry): entry is [string, Uint8Array] => entry[1] instanceof Uint8Array);
  const value = Object.fromEntries(Object.entries(fields).filter(([, field]) => !(field instanceof Uint8Array)));
  const json = new TextEncoder().encode(JSON.stringify({ value, blobs: blobs.map(([field, bytes]) => [field, bytes.length]) }));
  const message = new Uint8Array(blobs.reduce((sum, [, bytes]) => sum + bytes.length, 4 + json.length));
  new DataView(message.buffer).setUint32(0, json.length, true);
  message.set(json, 4);
  let offset = 4 + json.length;
  for (const [, bytes] of blobs) {
    message.set(bytes, offset);
    offset += bytes.length;
  }
  return message;
}

/**
 * Decodes a message. The blobs are views into `message`.
 *
 * @throws If the bytes are not a message.
 */
export function decodeMessage(message: Uint8Array): Record<string, unknown> {
  if (message.length < 4) throw new Error('The message is too short.');
  const jsonLength = new DataView(message.buffer, message.byteOffset).getUint32(0, true);
  if (4 + jsonLength > message.length) throw new Error('The message is cut off.');
  const envelope: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(message.subarray(4, 4 + jsonLength)));
  if (!isEnvelope(envelope)) throw new Error('The message has no envelope.');
  const fields: Record<string, unknown> = { ...envelope.value };
  let offset = 4 + jsonLength;
  for (const [field, length] of envelope.blobs) {
    if (offset + length > message.length) throw new Error('The message is cut off.');
    fields[field] = message.subarray(offset, offset + length);
    offset += length;
  }
  if (offset !== message.length) throw new Error('The message is longer than it says.');
  return fields;
}

function isEnvelope(value: unknown): value is Envelope {
  if (typeof value !== 'object' || value === null || !('value' in value) || !('blobs' in value)) return false;
  if (typeof value.value !== 'object' || value.value === null || !Array.isArray(value.blobs)) return false;
  return value.blobs.every(
    (blob: unknown) => Array.isArray(blob) && typeof blob[0] === 'string' && Number.isInteger(blob[1]) && (blob[1] as number) >= 0,
  );
}
