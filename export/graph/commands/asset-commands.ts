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
  /** From `makeAssetId`, or of an asset that is there. */
  readonly id: string;
  readonly asset: Asset;
}

/** Adds an asset to the table, or says something else of one. The file itself is the host's business. */
export function putAsset(project: Project, { id, asset }: PutAsset): Change {
  if (!isEntryId(id)) throw new Error(`${id} is no id of an asset.`);
  const problem = assetPathProblem(asset.path);
  if (problem !== null) return refuse(project, 'SCR031', `The path ${JSON.stringify(asset.path.slice(0, 120))} is invalid: ${problem}.`);
  return change(project, (draft) => {
    draft.assets[id] = castDraft(asset);
  });
}

/** Params that name the asset then name none. */
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
