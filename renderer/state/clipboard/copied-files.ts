import { HostError } from '../../../app/contract/host-error.ts';
import { loadProject } from '../../../export/graph/load.ts';
import type { Asset } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { CopiedDependencies, CopiedFiles } from '../editor/clipping.ts';
import type { Editor } from '../editor/editor.ts';
import { toastDiagnostic } from '../editor/ui.ts';
import { base64Of, bytesOf } from '../files/base64.ts';
import { showRefusal } from '../files/files.ts';
import { isGlb, isGltf, wholeModel } from '../files/whole-models.ts';

function assetsOf(brought: CopiedDependencies | undefined): Readonly<Record<string, Asset>> {
  return (brought === undefined ? null : loadProject(brought).output)?.assets ?? {};
}

export function isCopiedFiles(value: unknown): value is CopiedFiles | undefined {
  if (value === undefined) return true;
  return typeof value === 'object' && value !== null && Object.values(value).every((text) => typeof text === 'string');
}

export function hasAssets(brought: CopiedDependencies | undefined): boolean {
  return Object.keys(assetsOf(brought)).length > 0;
}

const MISSING_FIX = 'Put it beside the model in the project’s assets folder, or import the model as one .glb file.';

/**
 * Reads the asset files; packs models with the files that they refer to. Shows a message for unreadable files and leaves them out.
 */
export async function readCopiedFiles(editor: Editor, brought: CopiedDependencies | undefined): Promise<CopiedFiles> {
  const { open } = editor.document.getState();
  const files: Record<string, string> = {};
  if (open === null) return files;
  const read = async (path: string) => bytesOf((await editor.host.call('asset.read', { handle: open.handle, path })).base64);
  for (const [id, { path, kind }] of Object.entries(assetsOf(brought))) {
    try {
      const { base64 } = await editor.host.call('asset.read', { handle: open.handle, path });
      if (kind !== 'model' || !isGltf(path)) {
        files[id] = base64;
        continue;
      }
      const { file, diagnostic } = await wholeModel(path, bytesOf(base64), MISSING_FIX, (beside) => read(beside).catch(nullWhereMissing));
      if (diagnostic !== null) toastDiagnostic(editor.ui, diagnostic);
      if (file !== null) files[id] = base64Of(file.bytes);
    } catch (error) {
      showRefusal(editor, error);
    }
  }
  return files;
}

/** Returns null if the error says that a file is missing. Rethrows other errors, which have their own message. */
function nullWhereMissing(error: unknown): null {
  if (error instanceof HostError && error.diagnostic.code === 'SCR004') return null;
  throw error;
}

/** Imports the asset files that the open project lacks. Returns their paths, by asset id. */
export async function writeCopiedFiles(
  editor: Editor,
  brought: CopiedDependencies | undefined,
  files: CopiedFiles,
): Promise<ReadonlyMap<string, string>> {
  const { open, project } = editor.document.getState();
  const paths = new Map<string, string>();
  for (const [id, asset] of Object.entries(assetsOf(brought))) {
    const base64 = getOwn(files, id);
    if (open === null || base64 === undefined || getOwn(project.assets, id) !== undefined) continue;
    try {
      const bytes = bytesOf(base64);
      const known = asset.path.slice(asset.path.lastIndexOf('/') + 1);
      // A glTF model has been packed into one .glb file.
      const name = isGltf(known) && isGlb(bytes) ? known.replace(/gltf$/i, 'glb') : known;
      paths.set(id, (await editor.host.call('asset.import', { handle: open.handle, name, bytes })).path);
    } catch (error) {
      showRefusal(editor, error);
    }
  }
  return paths;
}
