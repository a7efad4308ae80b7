import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';

type Params = Readonly<Record<string, unknown>>;

export interface ProjectText {
  readonly title?: string;
  /** Node types by id, with params if needed. */
  readonly nodes: Readonly<Record<string, string | readonly [type: string, params: Params]>>;
  readonly wires: readonly string[];
  readonly assets?: Readonly<
    Record<string, { readonly path: string; readonly kind: 'image' | 'model' | 'video' | 'audio' | 'environment' | 'capture' | 'splats' }>
  >;
}

/** Text of a `project.scrim.json` from a short description. */
export function projectText({ title = 'Test', nodes, wires, assets }: ProjectText): string {
  const entries = Object.entries(nodes).map(([id, node]) => {
    const [type, params] = typeof node === 'string' ? [node] : node;
    return [id, { type, version: 1, ...(params && { params }) }];
  });
  const graphs = { main: { nodes: Object.fromEntries(entries), wires } };
  return JSON.stringify({ format: 'scrim-project', version: 1, title, graphs, ...(assets && { assets }) }, null, 2);
}

/** Writes the files of a project folder: text or bytes by path. */
export async function writeProject(folder: string, files: Readonly<Record<string, string | Uint8Array>>): Promise<void> {
  for (const [path, content] of Object.entries(files)) {
    await mkdir(dirname(join(folder, path)), { recursive: true });
    await writeFile(join(folder, path), content);
  }
}
