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
  readonly values?: unknown;
}

function pack(value: unknown): unknown {
  if (value === undefined) return { $undefined: true } satisfies Packed;
  if (typeof value === 'number')
    return isPlain(value) ? value : ({ $number: Object.is(value, -0) ? '-0' : String(value) } satisfies Packed);
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.every(isPlain) ? value : value.map(pack);
  const { name } = value.constructor ?? Object;
  if (name in TYPED) return { $typed: name as keyof typeof TYPED, values: pack(Array.from(value as Iterable<number>)) } satisfies Packed;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, pack(inner)]));
}

function unpack(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.every(isPlain) ? value : value.map(unpack);
  const { $undefined, $number, $typed, values } = value as Packed;
  if ($undefined) return undefined;
  if ($number !== undefined) return Number($number);
  if ($typed !== undefined) return TYPED[$typed].from(unpack(values) as number[]);
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
}

function isPlain(value: unknown): boolean {
  return typeof value === 'number' && Number.isFinite(value) && !Object.is(value, -0);
}
