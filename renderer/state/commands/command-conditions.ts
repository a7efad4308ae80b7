import type { AssetKind } from '../../../nodes/kit/definition.ts';
import { isDirty } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { idsOfKind } from '../editor/item-ids.ts';
import { soleNode } from '../editor/selection.ts';
import { canSimplify } from '../files/edit-assets.ts';
import { selectedSubgraph } from '../graph/subgraphs.ts';

export const always = () => true;
export const isOpen = ({ document }: Editor) => document.getState().open !== null;
export const hasCapture = (editor: Editor) => hasAsset(editor, (kind) => kind === 'capture');
export const hasMesh = (editor: Editor) => hasAsset(editor, canSimplify);
export const isUnsaved = ({ document }: Editor) => document.getState().open !== null && isDirty(document.getState());
export const canUndo = ({ document }: Editor) => document.getState().history.past.length > 0;
export const canRedo = ({ document }: Editor) => document.getState().history.future.length > 0;
export const hasNodes = ({ selection }: Editor) => selection.getState().nodes.size > 0;
export const hasSelection = ({ selection }: Editor) => Object.values(selection.getState()).some((set: ReadonlySet<string>) => set.size > 0);

export const hasFrames = ({ preview }: Editor) => preview.getState().frames !== null;
export const hasRange = ({ preview }: Editor) => preview.getState().frames !== null && preview.getState().range !== null;
export const hasSeveral = ({ selection }: Editor) => {
  const { nodes, items } = selection.getState();
  return nodes.size + idsOfKind(items, 'reroute').length > 1;
};
export const hasOneNode = ({ selection }: Editor) => soleNode(selection.getState()) !== null;
export const hasSubgraph = (editor: Editor) => selectedSubgraph(editor) !== null;
export const isInside = ({ document }: Editor) => document.getState().trail.length > 0;

function hasAsset({ document }: Editor, isWanted: (kind: AssetKind) => boolean): boolean {
  const { open, project } = document.getState();
  return open !== null && Object.values(project.assets).some(({ kind }) => isWanted(kind));
}
