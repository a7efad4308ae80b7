import { loadProject } from '../../export/graph/load.ts';
import { own } from '../../export/graph/own.ts';
import type { Asset } from '../../export/graph/project.ts';
import type { Brought } from './brought.ts';
import type { Editor } from './editor.ts';
import { showRefusal } from './files.ts';

/** What copied nodes' assets have in their files, by asset id, as base64: clipboards carry text alone between programs. */
export type CopiedFiles = Readonly<Record<string, string>>;

function assetsOf(brought: Brought | undefined): Readonly<Record<string, Asset>> {
  return (brought === undefined ? null : loadProject(brought).output)?.assets ?? {};
}

export function isCopiedFiles(value: unknown): value is CopiedFiles | undefined {
  if (value === undefined) return true;
  return typeof value === 'object' && value !== null && Object.values(value).every((text) => typeof text === 'string');
}

export function bringsFiles(brought: Brought | undefined): boolean {
  return Object.keys(assetsOf(brought)).length > 0;
}

/** Reads what the copied assets have in their files. What cannot be read is said and left out. */
export async function readCopiedFiles(editor: Editor, brought: Brought | undefined): Promise<CopiedFiles> {
  const { open } = editor.document.getState();
  const files: Record<string, string> = {};
  if (open === null) return files;
  for (const [id, { path }] of Object.entries(assetsOf(brought))) {
    try {
      files[id] = (await editor.host.call('asset.read', { handle: open.handle, path })).base64;
    } catch (error) {
      showRefusal(editor, error);
    }
  }
  return files;
}

/** Puts the files of assets that the open project does not have into it; asset id → the path that it has here. */
export async function writeCopiedFiles(
  editor: Editor,
  brought: Brought | undefined,
  files: CopiedFiles,
): Promise<ReadonlyMap<string, string>> {
  const { open, project } = editor.document.getState();
  const paths = new Map<string, string>();
  for (const [id, asset] of Object.entries(assetsOf(brought))) {
    const base64 = own(files, id);
    if (open === null || base64 === undefined || own(project.assets, id) !== undefined) continue;
    try {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const name = asset.path.slice(asset.path.lastIndexOf('/') + 1);
      paths.set(id, (await editor.host.call('asset.import', { handle: open.handle, name, bytes })).path);
    } catch (error) {
      showRefusal(editor, error);
    }
  }
  return paths;
}
