import type { KeptFiles } from '../../../nodes/kit/kept-files.ts';
import type { KeptStorage } from './anchor-memory.ts';

const KEY = 'scrim-kept-file';
/** Bytes per call of `String.fromCharCode`, whose number of arguments is limited. */
const PART = 8192;

/**
 * Creates the files that a page keeps over visits, as base64 in the storage of its origin.
 *
 * @param storage Where files are stored. If it is null or throws, as in private windows, none are kept.
 * @param page Path of the page.
 */
export function createKeptFiles(storage: KeptStorage | null, page: string): KeptFiles {
  const keyOf = (name: string): string => `${KEY}:${page}:${name}`;
  return {
    read: (name) => {
      try {
        const text = storage?.getItem(keyOf(name)) ?? null;
        return text === null ? null : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      } catch {
        // The storage is refused, or another script has written something else there: as many bytes as a file that says nothing.
        return storage ? new Uint8Array() : null;
      }
    },
    write: (name, bytes) => {
      let binary = '';
      for (let i = 0; i < bytes.length; i += PART) binary += String.fromCharCode(...bytes.subarray(i, i + PART));
      try {
        storage?.setItem(keyOf(name), btoa(binary));
        return storage !== null;
      } catch {
        return false;
      }
    },
    remove: (name) => {
      try {
        storage?.removeItem(keyOf(name));
      } catch {
        // The storage is refused, so it has no such file.
      }
    },
  };
}
