import { readSogMeta, SOG_META } from '../../../nodes/kit/splats/sog-meta.ts';
import { SplatError } from '../../../nodes/kit/splats/splats.ts';
import { writeZip } from '../../../nodes/kit/splats/zip-files.ts';

/** The used part of `File`. */
interface SogPart {
  readonly name: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** Splats that were found among other files. */
export interface FoundSog<T> {
  /** One SOG file; null if there is none, or if it cannot be made. */
  readonly sog: { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> } | null;
  /** Why it cannot be made: a sentence for the user. */
  readonly problem: string | null;
  readonly rest: readonly T[];
}

/** Packs the files of splats in the form SOG, `meta.json` with its images, into one SOG file. */
export async function packSog<T extends SogPart>(files: readonly T[]): Promise<FoundSog<T>> {
  const document = files.find(({ name }) => name.toLowerCase() === SOG_META);
  if (!document) return { sog: null, problem: null, rest: files };
  const used = new Set([document]);
  const packed = new Map([[SOG_META, new Uint8Array(await document.arrayBuffer())]]);
  try {
    for (const name of readSogMeta(new TextDecoder().decode(packed.get(SOG_META))).files) {
      const file = files.find((candidate) => candidate.name === name);
      if (!file) throw new SplatError(`its ${name} is missing`, 'Choose it together with its images.');
      used.add(file);
      packed.set(name, new Uint8Array(await file.arrayBuffer()));
    }
  } catch (error) {
    if (!(error instanceof SplatError)) throw error;
    const rest = files.filter((file) => !used.has(file) && !/\.webp$/i.test(file.name));
    return { sog: null, problem: `${document.name} cannot be imported as splats: ${error.message}. ${error.fix}`, rest };
  }
  return { sog: { name: 'splats.sog', bytes: writeZip(packed) }, problem: null, rest: files.filter((file) => !used.has(file)) };
}
