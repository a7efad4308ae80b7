import type { DroppedFolder, FolderFile } from '../acquisition/stage-folder.ts';

/** Levels of folders that are read. */
const MOST_LEVELS = 4;

/** The folder among dropped things; null if there is none. Call it during the event: later, the things are gone. */
export function droppedFolder(items: DataTransferItemList): DroppedFolder | null {
  for (const item of items) {
    const entry = item.kind === 'file' ? item.webkitGetAsEntry() : null;
    if (entry && isDirectory(entry)) return { name: entry.name, files: () => filesIn(entry, '', MOST_LEVELS) };
  }
  return null;
}

async function filesIn(folder: FileSystemDirectoryEntry, before: string, levels: number): Promise<readonly FolderFile[]> {
  const reader = folder.createReader();
  const found: FolderFile[] = [];
  for (;;) {
    // It gives some hundred entries at a time.
    const entries = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (entries.length === 0) return found;
    for (const entry of entries) {
      const path = `${before}${entry.name}`;
      if (isFile(entry)) found.push({ path, read: () => new Promise<File>((resolve, reject) => entry.file(resolve, reject)) });
      else if (isDirectory(entry) && levels > 0) found.push(...(await filesIn(entry, `${path}/`, levels - 1)));
    }
  }
}

function isDirectory(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}
