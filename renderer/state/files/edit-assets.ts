import { firstEye } from '../../../export/captures/first-eye.ts';
import { putAsset, removeAsset } from '../../../export/graph/commands/asset-commands.ts';
import { sequence } from '../../../export/graph/commands/change.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { readCapture } from '../../../nodes/kit/capture.ts';
import type { AssetKind } from '../../../nodes/kit/definition.ts';
import { apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { revealNodes } from '../editor/ui.ts';
import { goToNode, pathToGraph } from '../graph/graph-path.ts';
import { placeAsset } from '../graph/place-asset.ts';
import { type DroppedFile, type FileKind, importWhole } from './add-files.ts';
import { type AssetRow, isUnused, listAssets } from './asset-rows.ts';
import { bytesOf } from './base64.ts';
import { showRefusal } from './files.ts';
import { readBoundsOf } from './model-animations.ts';

/** Reads the list of asset files again, because other programs change them, too. */
export async function refreshAssetFiles(editor: Editor): Promise<void> {
  const handle = editor.document.getState().open?.handle;
  if (handle === undefined) return;
  try {
    const { assetFiles } = await editor.host.call('asset.list', { handle });
    editor.document.setState(({ open }) => ({ open: open?.handle === handle ? { ...open, assetFiles } : open }));
  } catch (error) {
    showRefusal(editor, error);
  }
}

/** Puts another file in the place of an asset, which all its nodes then use. Also finds a missing file again. */
export async function replaceAsset(editor: Editor, id: string, files: readonly DroppedFile[]): Promise<boolean> {
  const kind = getOwn(editor.document.getState().project.assets, id)?.kind;
  if (kind === undefined || !isFileKind(kind)) return false;
  const replaced = await editor.fileWork(async () => {
    const imported = await importWhole(editor, files, kind);
    const { project } = editor.document.getState();
    const before = getOwn(project.assets, id);
    if (imported === null || before === undefined) return false;
    // Author and license belong to the file before.
    return apply(editor, `Replace ${nameOf(before.path)}`, putAsset(project, { id, asset: imported }));
  });
  await refreshAssetFiles(editor);
  return replaced;
}

/** Removes assets that nothing uses from the project. Their files stay, so that undo brings the assets back. */
export function removeUnused(editor: Editor, ids: readonly string[]): boolean {
  const { project, library } = editor.document.getState();
  if (ids.length === 0) return false;
  const label = ids.length === 1 ? `Remove ${nameOf(getOwn(project.assets, ids[0] ?? '')?.path ?? '')}` : `Remove ${ids.length} assets`;
  return apply(editor, label, sequence(project, ...ids.map((id) => (before: typeof project) => removeAsset(before, { library, id }))));
}

export function unusedAssets(editor: Editor): readonly string[] {
  return listAssets(editor.document.getState()).rows.flatMap((row) => (isUnused(row) && row.id !== null ? [row.id] : []));
}

export async function revealAsset({ host, document, ...editor }: Editor, path: string): Promise<void> {
  const handle = document.getState().open?.handle;
  if (handle === undefined) return;
  try {
    await host.call('asset.reveal', { handle, path });
  } catch (error) {
    showRefusal({ host, document, ...editor }, error);
  }
}

/** Adds a node for an asset of the project, and selects it. A captured place without a floor stands so that the visitor sees what a photograph shows. */
export async function addAssetToGraph(editor: Editor, id: string, place: Place): Promise<string | null> {
  const { open, project } = editor.document.getState();
  const asset = getOwn(project.assets, id);
  if (asset === undefined || open === null) return null;
  const start = asset.kind === 'capture' ? await startOf(editor, asset.path) : null;
  const size = open.assetFiles.find(({ path }) => path === asset.path)?.bytes;
  const bounds = asset.kind === 'model' ? await readBoundsOf(editor, { handle: open.handle, path: asset.path, bytes: size }) : null;
  // Reading takes time, in which the asset may go.
  if (getOwn(editor.document.getState().project.assets, id) !== asset) return null;
  const node = placeAsset(editor, { id, asset, start, bounds }, place);
  if (node !== null) selectOnly(editor.selection, [node]);
  return node;
}

/** A camera that is lower stands in the floor, so the floor of the capture is not known. */
const LOWEST_CAMERA_M = 0.05;

/** Where a visitor begins in a captured place; null if its floor is at height 0, as in photographs of a scene, or it cannot be read. */
async function startOf({ host, document }: Editor, path: string) {
  const handle = document.getState().open?.handle;
  if (handle === undefined) return null;
  try {
    const { base64 } = await host.call('asset.read', { handle, path });
    const { views } = readCapture(new TextDecoder().decode(bytesOf(base64)));
    return views.some(({ worldFromCamera }) => (worldFromCamera[13] ?? 0) < LOWEST_CAMERA_M) ? firstEye(views) : null;
  } catch {
    // The check of the project says what is wrong with the file.
    return null;
  }
}

/** Selects the nodes that use an asset: those of the open graph, or of the next graph if they are selected already. */
export function goToUses(editor: Editor, { uses }: AssetRow): void {
  const { project, graph } = editor.document.getState();
  const graphs = [...new Set(uses.map((use) => use.graph))];
  const inGraph = (name: string) => uses.flatMap((use) => (use.graph === name ? [use.node] : []));
  const selected = editor.selection.getState().nodes;
  const shown = inGraph(graph);
  const isShown = shown.length > 0 && shown.length === selected.size && shown.every((node) => selected.has(node));
  const wanted = shown.length > 0 && !isShown ? graph : graphs[(graphs.indexOf(graph) + 1) % graphs.length];
  const [first, ...others] = wanted === undefined ? [] : inGraph(wanted);
  if (wanted === undefined || first === undefined) return;
  goToNode(editor, { graph: wanted, trail: pathToGraph(project, wanted), node: first });
  if (others.length === 0) return;
  selectOnly(editor.selection, [first, ...others]);
  if (wanted === graph) revealNodes(editor.ui, [first, ...others]);
}

/** Whether assets of a kind are single files, which the editor can import. */
export function isFileKind(kind: AssetKind): kind is FileKind {
  return kind !== 'capture';
}

/** Whether assets of a kind have a mesh that can be made smaller. */
export function canSimplify(kind: AssetKind): boolean {
  return kind === 'model' || kind === 'capture';
}

/** The name of an asset for people: its file, or the folder of a capture. */
export function nameOf(path: string): string {
  return path.replace(/^assets\//, '').replace(/\/capture\.json$/, '');
}
