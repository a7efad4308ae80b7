import { readdir, readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { PROJECT_FILE } from './project-files.ts';

export interface Example {
  readonly title: string;
  readonly path: string;
  /** As a `data:` address. */
  readonly picture?: string;
}

/** Beside the examples: what each shows, as `NAME.jpg`, and what a template does, as `template-NAME.jpg`. */
const PICTURES = 'pictures';

/** The projects directly below a folder, by name. */
export async function findExamples(examplesDir: string): Promise<Example[]> {
  const entries = await readdir(examplesDir, { withFileTypes: true }).catch(() => []);
  const folders = entries.filter((entry) => entry.isDirectory()).map((entry) => join(examplesDir, entry.name));
  const found = await Promise.all(folders.sort().map(readExample));
  return Promise.all(
    found.filter((example) => example !== null).map(async (example) => withPicture(example, examplesDir, basename(example.path))),
  );
}

/** Pictures are small, and crossing with the list saves a way of their own to the editor's origin. */
export async function withPicture<T extends object>(item: T, examplesDir: string, name: string): Promise<T & { picture?: string }> {
  const bytes = await readFile(pictureOf(examplesDir, name)).catch(() => null);
  return bytes === null ? item : { ...item, picture: `data:image/jpeg;base64,${bytes.toString('base64')}` };
}

export function pictureOf(examplesDir: string, name: string): string {
  return join(examplesDir, PICTURES, `${name}.jpg`);
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
