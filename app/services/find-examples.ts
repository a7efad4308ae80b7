import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { PROJECT_FILE } from './project-files.ts';

export interface Example {
  readonly title: string;
  readonly path: string;
}

/** The projects directly below a folder, by name. */
export async function findExamples(examplesDir: string): Promise<Example[]> {
  const entries = await readdir(examplesDir, { withFileTypes: true }).catch(() => []);
  const folders = entries.filter((entry) => entry.isDirectory()).map((entry) => join(examplesDir, entry.name));
  const found = await Promise.all(folders.sort().map(readExample));
  return found.filter((example) => example !== null);
}

async function readExample(path: string): Promise<Example | null> {
  const text = await readFile(join(path, PROJECT_FILE), 'utf8').catch(() => null);
  if (text === null) return null;
  try {
    const { title } = JSON.parse(text) as { title?: unknown };
    return typeof title === 'string' ? { title, path } : null;
  } catch {
    return null;
  }
}
