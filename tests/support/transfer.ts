/**
 * Values between a test and its page, as JSON text. Playwright sends them, too, but number by number: an image of a million numbers takes
 * it 60 times as long. Besides JSON, `undefined`, NaN, infinities, -0 and typed arrays arrive as they are. Of objects of other classes
 * their own properties arrive, as with Playwright.
 */
export function encodeTransfer(value: unknown): string {
  return JSON.stringify(pack(value));
}

/** Reads what `encodeTransfer` wrote. */
export function decodeTransfer(text: string): unknown {
  return unpack(JSON.parse(text));
}

const TYPED = { Uint8Array, Uint8ClampedArray, Int8Array, Uint16Array, Int16Array, Uint32Array, Int32Array, Float32Array, Float64Array };

/** An object with one of these keys stands for a value that JSON lacks. */
interface Packed {
  readonly $undefined?: true;
  readonly $number?: string;
  readonly $typed?: keyof typeof TYPED;
  readonly base64?: string;
}

function pack(value: unknown): unknown {
  if (value === undefined) return { $undefined: true } satisfies Packed;
  if (typeof value === 'number')
    return isPlain(value) ? value : ({ $number: Object.is(value, -0) ? '-0' : String(value) } satisfies Packed);
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.every(isPlain) ? value : value.map(pack);
  const { name } = value.constructor ?? Object;
  if (name in TYPED) return { $typed: name as keyof typeof TYPED, base64: base64Of(value as Uint8Array) } satisfies Packed;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, pack(inner)]));
}

function unpack(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.every(isPlain) ? value : value.map(unpack);
  const { $undefined, $number, $typed, base64 } = value as Packed;
  if ($undefined) return undefined;
  if ($number !== undefined) return Number($number);
  if ($typed !== undefined) return new TYPED[$typed](bytesOf(base64 ?? ''));
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
}

/** The bytes of a typed array as text: as a list of numbers an image takes ten times as long. */
function base64Of({ buffer, byteOffset, byteLength }: ArrayBufferView): string {
  if (typeof Buffer !== 'undefined') return Buffer.from(buffer as ArrayBuffer, byteOffset, byteLength).toString('base64');
  const bytes = new Uint8Array(buffer, byteOffset, byteLength);
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}

function bytesOf(base64: string): ArrayBuffer {
  if (typeof Buffer !== 'undefined') return Uint8Array.from(Buffer.from(base64, 'base64')).buffer;
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0)).buffer;
}

function isPlain(value: unknown): boolean {
  return typeof value === 'number' && Number.isFinite(value) && !Object.is(value, -0);
}
