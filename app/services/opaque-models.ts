import type { Asset } from '../../export/graph/project.ts';
import { resolveInside } from './confine.ts';
import { readRange, readText } from './read-file.ts';

/** What the materials of a glTF document say about transparency (glTF 2.0, section 3.9.4). */
interface Materials {
  readonly materials?: readonly { readonly alphaMode?: string; readonly extensions?: Readonly<Record<string, unknown>> }[];
}

/** The header of a GLB file and of its first chunk, which is the document (glTF 2.0, section 4.4). */
const GLB_HEAD_BYTES = 20;
const GLB_MAGIC = 'glTF';
const DOCUMENT_BYTES_AT = 12;

/** A larger document counts as one with transparent materials. */
const MAX_DOCUMENT_BYTES = 16 * 2 ** 20;

/** The extension of materials that show what is behind them. */
const GLASS = 'KHR_materials_transmission';

/**
 * Finds the models of a project without transparent materials: none has the alpha mode `BLEND`, and none is glass. A file that cannot be read
 * is not among them.
 *
 * @param root Folder of the project.
 * @returns Ids of the assets.
 */
export async function findOpaqueModels(root: string, assets: Readonly<Record<string, Asset>>): Promise<readonly string[]> {
  const found = await Promise.all(
    Object.entries(assets).map(async ([id, { kind, path }]) => {
      if (kind !== 'model') return [];
      try {
        return isOpaque(JSON.parse(await readDocument(await resolveInside(root, path)))) ? [id] : [];
      } catch {
        // `checkModels` reports it.
        return [];
      }
    }),
  );
  return found.flat();
}

async function readDocument(path: string): Promise<string> {
  const head = await readRange(path, 0, GLB_HEAD_BYTES);
  if (head.toString('latin1', 0, GLB_MAGIC.length) !== GLB_MAGIC) return readText(path, MAX_DOCUMENT_BYTES);
  const bytes = Math.min(head.readUInt32LE(DOCUMENT_BYTES_AT), MAX_DOCUMENT_BYTES);
  return (await readRange(path, GLB_HEAD_BYTES, bytes)).toString('utf8');
}

function isOpaque({ materials = [] }: Materials): boolean {
  return materials.every(({ alphaMode, extensions = {} }) => alphaMode !== 'BLEND' && !(GLASS in extensions));
}
