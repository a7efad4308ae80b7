import { oneAsset } from '../../../nodes/kit/asset-words.ts';
import type { AssetKind } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { ProgramAsset } from '../../program/program.ts';

/** Says that a node refers to an asset that the project does not have. */
export function missing(id: string): Omit<Diagnostic, 'nodeId'> {
  return { code: 'SCR030', severity: 'error', message: `The asset "${id}" is not in the project.`, fix: 'Choose another one.' };
}

/** Says that a node refers to an asset of another kind than it needs. */
export function wrongKind(asset: ProgramAsset, wanted: AssetKind): Omit<Diagnostic, 'nodeId'> {
  const message = `"${asset.path}" is ${oneAsset(asset.kind)}, but the node needs ${oneAsset(wanted)}.`;
  return { code: 'SCR033', severity: 'error', message, fix: 'Choose another asset.' };
}
