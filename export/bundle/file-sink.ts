/** Where a page's files go. Paths are relative, `/` between parts, and each is written once. */
export interface FileSink {
  write(path: string, bytes: Uint8Array): Promise<void>;
}
