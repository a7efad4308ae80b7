import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { EMBEDDED_TYPE } from './page-html.ts';

export function hasEmbeddedFiles(document: Document): boolean {
  return find(document).length > 0;
}

/** Loads files from base64 data blocks of the page, because a page opened from a disk cannot fetch files beside it. */
export function createEmbeddedAssetSource(document: Document): AssetSource {
  return {
    load: async (path) => {
      const block = [...find(document)].find(({ dataset }) => dataset.path === path);
      if (!block) throw new Error('there is no such file');
      return fromBase64(block.textContent ?? '');
    },
  };
}

function find(document: Document): NodeListOf<HTMLScriptElement> {
  return document.querySelectorAll<HTMLScriptElement>(`script[type="${EMBEDDED_TYPE}"]`);
}

function fromBase64(text: string): ArrayBuffer {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}
