import { createWriteStream } from 'node:fs';
import { lstat, readdir, readFile, readlink } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import { Readable } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { crc32 } from 'node:zlib';

/*
 * The packager takes Electron as the ZIP that its makers publish, and as nothing else. This makes one of an unpacked Electron:
 * stored, not deflated, because it is read once and thrown away. Layout: PKWARE APPNOTE 6.3.10, sections 4.3.7, 4.3.12, 4.3.16;
 * names are UTF-8 (flag bit 11), modes and links as Unix has them (version made by: 3).
 */
const UTF8_NAMES = 0x0800;
const MADE_BY_UNIX = (3 << 8) | 20;
const VERSION_NEEDED = 20;
/** 1980-01-01, the first date of ZIP files. */
const DATE = 0x0021;

interface ZipEntry {
  readonly name: Buffer;
  readonly mode: number;
  readonly crc: number;
  readonly size: number;
  readonly offset: number;
}

/**
 * Writes a ZIP below 4 GiB, because ZIP64 is not supported.
 *
 * @param skip Excludes files by their path.
 */
export async function zipFolder(folder: string, target: string, skip: (path: string) => boolean = () => false): Promise<void> {
  await pipeline(Readable.from(zipParts(folder, skip)), createWriteStream(target));
}

async function* zipParts(folder: string, skip: (path: string) => boolean): AsyncGenerator<Buffer> {
  const entries: ZipEntry[] = [];
  let offset = 0;
  for (const path of await listPaths(folder)) {
    if (skip(path)) continue;
    const { mode, bytes } = await readEntry(join(folder, path));
    const entry = { name: Buffer.from(path), mode, crc: crc32(bytes), size: bytes.length, offset };
    entries.push(entry);
    const head = localHead(entry);
    offset += head.length + bytes.length;
    yield head;
    yield bytes;
  }
  const directory = Buffer.concat(entries.map(directoryEntry));
  yield directory;
  yield endOfDirectory(entries.length, directory.length, offset);
}

async function listPaths(folder: string): Promise<readonly string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => !entry.isDirectory())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .sort();
}

async function readEntry(path: string): Promise<{ mode: number; bytes: Buffer }> {
  const found = await lstat(path);
  return { mode: found.mode, bytes: found.isSymbolicLink() ? Buffer.from(await readlink(path)) : await readFile(path) };
}

function localHead({ name, crc, size }: ZipEntry): Buffer {
  const head = Buffer.alloc(30);
  head.writeUInt32LE(0x04034b50, 0);
  writeShared(head, 4, crc, size, name.length);
  return Buffer.concat([head, name]);
}

function directoryEntry({ name, mode, crc, size, offset }: ZipEntry): Buffer {
  const head = Buffer.alloc(46);
  head.writeUInt32LE(0x02014b50, 0);
  head.writeUInt16LE(MADE_BY_UNIX, 4);
  writeShared(head, 6, crc, size, name.length);
  head.writeUInt32LE((mode << 16) >>> 0, 38);
  head.writeUInt32LE(offset, 42);
  return Buffer.concat([head, name]);
}

/**
 * Fields that local and central headers share: version, flags, method (0: stored), time, date, checksum, both sizes, length of the
 * name.
 */
function writeShared(head: Buffer, at: number, crc: number, size: number, nameLength: number): void {
  head.writeUInt16LE(VERSION_NEEDED, at);
  head.writeUInt16LE(UTF8_NAMES, at + 2);
  head.writeUInt16LE(DATE, at + 8);
  head.writeUInt32LE(crc, at + 10);
  head.writeUInt32LE(size, at + 14);
  head.writeUInt32LE(size, at + 18);
  head.writeUInt16LE(nameLength, at + 22);
}

function endOfDirectory(count: number, length: number, offset: number): Buffer {
  const end = Buffer.alloc(22);
  end.writeUInt32LE(0x06054b50, 0);
  end.writeUInt16LE(count, 8);
  end.writeUInt16LE(count, 10);
  end.writeUInt32LE(length, 12);
  end.writeUInt32LE(offset, 16);
  return end;
}
