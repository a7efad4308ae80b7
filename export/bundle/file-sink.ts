/** Receives the files of a page. Paths are relative with `/` between folders; each is written once. */
export interface FileSink {
  write(path: string, bytes: Uint8Array): Promise<void>;
}
