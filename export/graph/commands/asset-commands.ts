import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { assetPathProblem } from '../asset-path.ts';
import { isEntryId } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { boundValue } from '../library/param-value.ts';
import type { Asset, Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { type Change, change, draftGraph, refuse } from './change.ts';

export interface PutAsset {
  /** From `makeAssetId`, or the id of an existing asset. */
  readonly id: string;
  readonly asset: Asset;
}

/**
 * Adds an asset to the asset table or replaces its entry. The caller copies the file.
 *
 * @returns The change, or a refusal with SCR031 if the path is invalid.
 * @throws Error if `id` is not an asset id.
 *
 * @example
 * const { project: next } = putAsset(project, { id: 'statue', asset: { kind: 'model', path: 'assets/statue.glb' } });
 */
export function putAsset(project: Project, { id, asset }: PutAsset): Change {
  if (!isEntryId(id)) throw new Error(`${id} is not an asset id.`);
  const problem = assetPathProblem(asset.path);
  if (problem !== null) return refuse(project, 'SCR031', `The path ${JSON.stringify(asset.path.slice(0, 120))} is invalid: ${problem}.`);
  return change(project, (draft) => {
    draft.assets[id] = castDraft(asset);
  });
}

/**
 * Removes an asset from the asset table and resets the params that refer to it. The file is not deleted.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * const { project: next } = removeAsset(project, { library, id: 'statue' });
 */
export function removeAsset(project: Project, { library, id }: { readonly library: NodeLibrary; readonly id: string }): Change {
  const interfaceOf = createInterfaceLookup(project, library);
  return change(project, (draft) => {
    delete draft.assets[id];
    for (const [name, graph] of Object.entries(project.graphs)) {
      for (const [nodeId, node] of Object.entries(graph.nodes)) {
        for (const [param, binding] of Object.entries(node.params)) {
          if (boundValue(binding) !== id) continue;
          const nodeInterface = interfaceOf(node.type);
          if (nodeInterface && getOwn(nodeInterface.params, param)?.type === 'asset')
            delete draftGraph(draft, name).nodes[nodeId]?.params[param];
        }
      }
    }
  });
}
