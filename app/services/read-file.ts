import { constants, type Stats } from 'node:fs';
import { type FileHandle, lstat, open } from 'node:fs/promises';

/*
 * All files of a project are opened here. Projects may come from strangers: opening a named pipe blocks a thread of the file system
 * pool forever, and opening a device can have any effect.
 */

/** The path is not a regular file. `code` has the form of system error codes. */
export class NotAFileError extends Error {
  readonly code = 'ENOTFILE';
  /** Kind of the file, with its article: “a named pipe”. */
  readonly what: string;
  constructor(path: string, what: string) {
    super(`${path} is ${what}, not a file.`);
    this.what = what;
  }
}

/** The file is larger than the limit of the reader. */
export class TooLargeError extends Error {
  readonly code = 'ETOOLARGE';
  readonly bytes: number;
  readonly maxBytes: number;
  constructor(path: string, bytes: number, maxBytes: number) {
    super(`${path} has ${inMegabytes(bytes)}; at most ${inMegabytes(maxBytes)} can be read.`);
    this.bytes = bytes;
    this.maxBytes = maxBytes;
  }
}

/** Flags for opening without following links or blocking on pipes. Windows lacks both flags, and has no pipes or devices in folders. */
const FLAGS = constants.O_RDONLY | (constants.O_NOFOLLOW ?? 0) | (constants.O_NONBLOCK ?? 0);

/**
 * Opens a regular file for reading. The caller closes it. Rejects with `NotAFileError` for links, pipes, devices, sockets and
 * folders, without opening them, and with system errors.
 */
export async function openFile(path: string): Promise<FileHandle> {
  await statFile(path);
  const file = await open(path, FLAGS);
  try {
    // The file may have been replaced in between; `O_NONBLOCK` keeps the open from blocking.
    refuseOthers(path, await file.stat());
    return file;
  } catch (error) {
    await file.close();
    throw error;
  }
}

/** The size and times of a regular file. Rejects like `openFile`. */
export async function statFile(path: string): Promise<Stats> {
  const stats = await lstat(path);
  refuseOthers(path, stats);
  return stats;
}

/** Reads a regular file. Rejects like `openFile`, and with `TooLargeError` before reading. */
export function readBytes(path: string, maxBytes: number): Promise<Uint8Array<ArrayBuffer>> {
  return readOpened(path, maxBytes, async (file) => new Uint8Array(await file.readFile()));
}

/** Reads the text of a regular file. Rejects like `readBytes`. */
export function readText(path: string, maxBytes: number): Promise<string> {
  return readOpened(path, maxBytes, (file) => file.readFile('utf8'));
}

/** Reads at most `bytes` of a regular file from the offset `from`; fewer at its end. Rejects like `openFile`. */
export async function readRange(path: string, from: number, bytes: number): Promise<Buffer> {
  const file = await openFile(path);
  try {
    const part = Buffer.alloc(bytes);
    const { bytesRead } = await file.read(part, 0, bytes, from);
    return part.subarray(0, bytesRead);
  } finally {
    await file.close();
  }
}

async function readOpened<T>(path: string, maxBytes: number, read: (file: FileHandle) => Promise<T>): Promise<T> {
  const file = await openFile(path);
  try {
    const { size } = await file.stat();
    if (size > maxBytes) throw new TooLargeError(path, size, maxBytes);
    return await read(file);
  } finally {
    await file.close();
  }
}

function refuseOthers(path: string, stats: Stats): void {
  if (!stats.isFile()) throw new NotAFileError(path, kindOf(stats));
}

function kindOf(stats: Stats): string {
  if (stats.isDirectory()) return 'a folder';
  if (stats.isSymbolicLink()) return 'a link';
  if (stats.isFIFO()) return 'a named pipe';
  if (stats.isSocket()) return 'a socket';
  return 'a device';
}

function inMegabytes(bytes: number): string {
  return `${Math.round(bytes / 2 ** 20).toLocaleString('en-US')} MB`;
}
