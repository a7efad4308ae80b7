import type { HostInput, HostOutput } from '../../../app/contract/contract.ts';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { makeAssetId } from '../../../export/graph/document-names.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { apply } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { nameOf, refreshAssetFiles } from '../files/edit-assets.ts';
import { asked, runOutside } from './outside-run.ts';

export type Simplifier = HostInput<'simplify.run'>['program'];

export interface SimplifyRequest {
  /** Id of a model or capture. */
  readonly id: string;
  readonly program: Simplifier;
  /** Path of the program; empty: that of the host. */
  readonly executable: string;
  readonly triangles: number;
  /** Whether the nodes that use the asset use the result. */
  readonly replaces: boolean;
}

/** The triangles of an asset and the program, or why the asset cannot be read. */
export type SimplifyLook = HostOutput<'simplify.look'> | Diagnostic;

export function lookAtMesh(editor: Editor, path: string, program: Simplifier, executable: string): Promise<SimplifyLook | null> {
  return asked(editor, (handle) => editor.host.call('simplify.look', { handle, path, program, executable: executable || null }));
}

/**
 * Makes a model or capture smaller with a program of others. The result is a new asset, or takes the place of the one before, whose files stay,
 * so that undo brings it back.
 *
 * @returns Whether it succeeded.
 */
export async function simplifyAsset(editor: Editor, request: SimplifyRequest): Promise<boolean> {
  const { id, program, executable, triangles, replaces } = request;
  const asset = getOwn(editor.document.getState().project.assets, id);
  if (asset === undefined) return false;
  return runOutside(editor, {
    dialog: 'simplify',
    begin: { step: 'read', text: 'Reading the mesh…' },
    canceled: { text: 'Simplification canceled.', detail: 'Nothing was changed.' },
    run: (handle) => editor.host.call('simplify.run', { handle, path: asset.path, program, executable: executable || null, triangles }),
    show: async (path, { before, after }) => {
      await editor.fileWork(async () => {
        const { project } = editor.document.getState();
        // It may be gone meanwhile; author and license are those of the asset before.
        const old = getOwn(project.assets, id);
        const target = replaces && old !== undefined ? id : makeAssetId(project, nameOf(path), editor.random);
        const label = target === id ? `Simplify ${nameOf(asset.path)}` : `Add ${nameOf(path)}`;
        apply(editor, label, putAsset(project, { id: target, asset: { ...asset, path } }));
      });
      await refreshAssetFiles(editor);
      editor.ui.setState({ bottom: 'assets' });
      addToast(editor.ui, {
        tone: 'success',
        text: `${replaces ? `Simplified ${nameOf(asset.path)}` : `Added ${nameOf(path)}`}.`,
        detail: `${countText(after)} triangles instead of ${countText(before)}.`,
      });
    },
  });
}

/** A whole number with commas between thousands. */
export function countText(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ',');
}
