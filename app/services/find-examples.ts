import { readdir } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { MAX_DOCUMENT_BYTES, PROJECT_FILE } from './project-files.ts';
import { readBytes, readText } from './read-file.ts';

export interface Example {
  readonly title: string;
  readonly path: string;
  /** Node types in the example. */
  readonly types: string[];
  /** Image as a `data:` URL. */
  readonly picture?: string;
}

/** Folder of images beside the examples: `NAME.jpg` for examples, `template-NAME.jpg` for templates. */
const PICTURES = 'pictures';
const MAX_THUMBNAIL_BYTES = 4 * 2 ** 20;

/** The projects directly in a folder, by name. */
export async function findExamples(examplesDir: string): Promise<Example[]> {
  const entries = await readdir(examplesDir, { withFileTypes: true }).catch(() => []);
  const folders = entries.filter((entry) => entry.isDirectory()).map((entry) => join(examplesDir, entry.name));
  const found = await Promise.all(folders.sort().map(readExample));
  return Promise.all(
    found.filter((example) => example !== null).map(async (example) => withThumbnail(example, examplesDir, basename(example.path))),
  );
}

/** Adds the image as a `data:` URL. Images are small, so they need no URL of their own. */
export async function withThumbnail<T extends object>(item: T, examplesDir: string, name: string): Promise<T & { picture?: string }> {
  const bytes = await readBytes(pictureOf(examplesDir, name), MAX_THUMBNAIL_BYTES).catch(() => null);
  return bytes === null ? item : { ...item, picture: `data:image/jpeg;base64,${Buffer.from(bytes).toString('base64')}` };
}

export function pictureOf(examplesDir: string, name: string): string {
  return join(examplesDir, PICTURES, `${name}.jpg`);
}

async function readExample(path: string): Promise<Example | null> {
  const text = await readText(join(path, PROJECT_FILE), MAX_DOCUMENT_BYTES).catch(() => null);
  if (text === null) return null;
  try {
    const { title, graphs } = JSON.parse(text) as { title?: unknown; graphs?: unknown };
    return typeof title === 'string' ? { title, path, types: typesIn(graphs) } : null;
  } catch {
    return null;
  }
}

/** The node types in the graphs of a project. Users may edit example files, so invalid nodes are skipped. */
function typesIn(graphs: unknown): string[] {
  const nodes = values(graphs).flatMap((graph) => values((graph as { nodes?: unknown } | null)?.nodes));
  const types = nodes.map((node) => (node as { type?: unknown } | null)?.type).filter((type) => typeof type === 'string');
  return [...new Set(types)].sort();
}

function values(table: unknown): unknown[] {
  return typeof table === 'object' && table !== null ? Object.values(table) : [];
}
