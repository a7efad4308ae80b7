import type { WebGLRenderer } from 'three';
import type { DecoderName } from '../../../../gltf/decoders.ts';
import { ModelError } from '../../../../gltf/document.ts';
import type { DecoderFiles, ModelDecoder, ModelDecoders } from './decoder.ts';

/**
 * Provides decoders while models load. A decoder is opened for the first model that needs it and closed after the last one, to free its
 * memory.
 */
export interface DecoderPool {
  /** Runs `work` with open decoders. Rejects with `ModelError` if the page does not have a decoder or its files cannot be read. */
  use<T>(names: readonly DecoderName[], work: (decoders: readonly ModelDecoder[]) => Promise<T>): Promise<T>;
}

interface Entry {
  users: number;
  readonly opening: Promise<ModelDecoder>;
}

export function createDecoderPool(decoders: ModelDecoders, files: DecoderFiles, renderer: WebGLRenderer): DecoderPool {
  const open = new Map<DecoderName, Entry>();

  const acquire = (name: DecoderName): Entry => {
    const openDecoder = decoders[name];
    if (!openDecoder) throw new ModelError(`the decoder for ${TITLES[name]} is not part of this page.`);
    const entry = open.get(name) ?? { users: 0, opening: openDecoder(files, renderer) };
    open.set(name, entry);
    entry.users++;
    return entry;
  };
  const release = (name: DecoderName, entry: Entry): void => {
    if (--entry.users > 0) return;
    open.delete(name);
    // If opening failed, `use` has already rejected.
    entry.opening.then((decoder) => decoder.dispose()).catch(() => {});
  };
  return {
    use: async (names, work) => {
      const acquired: [DecoderName, Entry][] = [];
      try {
        for (const name of names) acquired.push([name, acquire(name)]);
        const ready = await Promise.all(acquired.map(([name, { opening }]) => opening.catch((error) => unopened(name, error))));
        return await work(ready);
      } finally {
        for (const [name, entry] of acquired) release(name, entry);
      }
    },
  };
}

const TITLES: Readonly<Record<DecoderName, string>> = { draco: 'Draco meshes', meshopt: 'meshopt meshes', ktx2: 'KTX2 textures' };

function unopened(name: DecoderName, error: unknown): never {
  throw new ModelError(`the decoder for ${TITLES[name]} cannot be loaded: ${error instanceof Error ? error.message : String(error)}`);
}
