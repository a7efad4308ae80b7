import type { PassSampler } from '../../program/program.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from './slot-allocator.ts';

export type Fit = Exclude<PassSampler['fit'], 'none'>;

const FITS: readonly Fit[] = ['cover', 'contain', 'stretch'];

/** How a node fits images of their own size to the view: its structure param `fit`, or `cover`. */
export function fitOf(node: FlatNode): Fit {
  const param = Object.hasOwn(node.definition.params, 'fit') ? node.definition.params.fit : undefined;
  const value = param?.stage === 'structure' ? startValue(node, 'fit', param) : undefined;
  return FITS.find((fit) => fit === value) ?? 'cover';
}
