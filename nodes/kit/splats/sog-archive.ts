import { readSogMeta, SOG_META, type SogMeta } from './sog-meta.ts';
import { SplatError } from './splats.ts';
import { readZip, unzip } from './zip-files.ts';

/** A SOG file, with all of its files present. */
export interface SogArchive {
  readonly meta: SogMeta;
  /** Unpacks a file of `meta.files`. */
  open(name: string): Promise<Uint8Array<ArrayBuffer>>;
}

/**
 * Opens a SOG file and checks that it is complete.
 *
 * @throws SplatError
 *
 * @example
 * const { meta, open } = await openSog(bytes);
 */
export async function openSog(bytes: Uint8Array<ArrayBuffer>): Promise<SogArchive> {
  const files = readZip(bytes);
  const open = async (name: string): Promise<Uint8Array<ArrayBuffer>> => {
    const file = files.get(name);
    if (!file) throw new SplatError(`its ${name} is missing`);
    return unzip(file);
  };
  const meta = readSogMeta(new TextDecoder().decode(await open(SOG_META)));
  const missing = meta.files.find((name) => !files.has(name));
  if (missing !== undefined) throw new SplatError(`its ${missing} is missing`);
  return { meta, open };
}
