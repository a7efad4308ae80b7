import { createHash } from 'node:crypto';
import type { CompressedModel } from '../compress/compressed-model.ts';

/** Stores results of slow work between exports. If `read` or `write` rejects, the export repeats the work. */
export interface AssetCache {
  /** Null if there is no entry. Names have letters, digits and dashes. */
  read(name: string): Promise<Uint8Array | null>;
  write(name: string, bytes: Uint8Array): Promise<void>;
}

/** Part of the names of cache entries. Increase this number if the compressor or its packages return different bytes for the same model. */
const COMPRESSOR_VERSION = 1;

/** Returns the compressed forms of a model from the cache, or creates them by `make`. */
export async function remembered(
  cache: AssetCache | null,
  bytes: Uint8Array,
  make: () => Promise<CompressedModel>,
): Promise<CompressedModel> {
  if (cache === null) return make();
  const name = `model-${COMPRESSOR_VERSION}-${createHash('sha256').update(bytes).digest('hex')}`;
  const kept = unpack(await cache.read(name).catch(() => null));
  if (kept) return kept;
  const made = await make();
  // A cache that cannot be written only costs time.
  await cache.write(name, pack(made)).catch(() => {});
  return made;
}

const HEAD_BYTES = 44;

/**
 * Packs a cache entry: a hash of the forms, the length of the first form, then both forms. `unpack` rejects a truncated or changed entry by
 * the hash.
 */
function pack({ meshopt, ktx2 }: CompressedModel): Uint8Array {
  const forms = Buffer.concat([meshopt ?? new Uint8Array(), ktx2 ?? new Uint8Array()]);
  const head = Buffer.alloc(HEAD_BYTES);
  hashOf(forms).copy(head);
  head.writeUInt32LE(meshopt?.length ?? 0, 32);
  return Buffer.concat([head, forms]);
}

function unpack(bytes: Uint8Array | null): CompressedModel | null {
  if (!bytes || bytes.length < HEAD_BYTES) return null;
  const head = Buffer.from(bytes.subarray(0, HEAD_BYTES));
  const forms = bytes.subarray(HEAD_BYTES);
  if (!hashOf(forms).equals(head.subarray(0, 32))) return null;
  const split = head.readUInt32LE(32);
  const form = (part: Uint8Array) => (part.length === 0 ? null : Uint8Array.from(part));
  return { meshopt: form(forms.subarray(0, split)), ktx2: form(forms.subarray(split)) };
}

function hashOf(bytes: Uint8Array): Buffer {
  return createHash('sha256').update(bytes).digest();
}
