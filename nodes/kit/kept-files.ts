/** Files that the page keeps for later visits. Types only; the runtime is in `export/runtime/spatial`. */
export interface KeptFiles {
  /** Returns a file; null if there is none of that name. Bytes that other scripts of the origin wrote there may be anything. */
  read(name: string): Uint8Array | null;
  /** Writes a file. Returns false if the browser does not store it: because it is full, or keeps nothing, as in private windows. */
  write(name: string, bytes: Uint8Array): boolean;
  remove(name: string): void;
}
