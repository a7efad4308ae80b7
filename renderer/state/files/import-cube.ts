import { lutImage } from '../../../export/glsl/lut/lut-image.ts';
import { readCube } from '../../../export/glsl/lut/read-cube.ts';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { sequence } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeAssetId, makeNodeId } from '../../../export/graph/document-names.ts';
import type { Project } from '../../../export/graph/project.ts';
import { type AddStep, apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { toastDiagnostic } from '../editor/ui.ts';
import { placeFreely } from '../graph/free-places.ts';
import { showRefusal } from './files.ts';

const PICTURE = 'source/image-file';
const TABLE = 'operator/color-lut';
const BETWEEN_PX = 260;

/**
 * Imports a color table (.cube) as one undo step: an image asset, a node for it, and a LUT node connected to it. Returns the ids of
 * both nodes; none after an error, which is shown.
 */
export async function addCube(
  editor: Editor,
  { name, text }: { readonly name: string; readonly text: string },
  place: Place,
  step: AddStep = {},
): Promise<string[]> {
  const { output, diagnostics } = readCube(text, name);
  for (const { line, message, fix, ...diagnostic } of diagnostics) {
    const where = line === undefined ? name : `${name}, line ${line}`;
    toastDiagnostic(editor.ui, { ...diagnostic, message: `${where}: ${message}`, ...(fix === undefined ? {} : { fix }) });
  }
  const { open } = editor.document.getState();
  if (output === null || open === null) return [];
  const { widthPx, heightPx, size, columns, rgba } = lutImage(output);
  // Loaded on demand, because color tables are rare.
  const { encode } = await import('fast-png');
  let path: string;
  try {
    const bytes = Uint8Array.from(encode({ width: widthPx, height: heightPx, data: rgba, channels: 4, depth: 8 }));
    ({ path } = await editor.host.call('asset.import', { handle: open.handle, name: name.replace(/\.cube$/i, '.png'), bytes }));
  } catch (error) {
    showRefusal(editor, error);
    return [];
  }
  const { project, library, graph } = editor.document.getState();
  const asset = makeAssetId(project, path, editor.random);
  const image = makeNodeId(project, PICTURE, editor.random);
  const table = makeNodeId(project, TABLE, editor.random);
  const right = { x: place.x + BETWEEN_PX, y: place.y };
  const change = sequence(
    project,
    (before: Project) => putAsset(before, { id: asset, asset: { path, kind: 'image' } }),
    (before: Project) => addNode(before, { library, graph, id: image, type: PICTURE, ...place, params: { file: asset } }),
    (before: Project) => addNode(before, { library, graph, id: table, type: TABLE, ...right, params: { size, columns } }),
    (before: Project) => connect(before, { library, graph, from: { node: image, port: 'layer' }, to: { node: table, port: 'table' } }),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  return apply(editor, step.label ?? `Add ${name}`, change, step.key) ? [image, table] : [];
}
