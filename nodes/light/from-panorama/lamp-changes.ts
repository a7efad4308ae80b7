import { choiceIndex } from '../../kit/choice-options.ts';
import type { NodeContext } from '../../kit/runtime.ts';
import type { NumberView } from '../../kit/value-views.ts';
import type { definition } from './definition.ts';
import type { LampKind } from './lamp-items.ts';

/** The settings of one lamp that differ from those of all lamps. */
export interface LampChange {
  readonly pinned: { readonly value: boolean };
  readonly azimuthRad: NumberView;
  readonly elevationRad: NumberView;
  /** 0: the kind of all lamps. Otherwise the index of the kind, plus 1. */
  readonly kind: NumberView;
  /** 0: the distance of all lamps. Otherwise meters. */
  readonly distanceM: NumberView;
}

const KINDS: readonly LampKind[] = ['directional', 'spot', 'point'];

/** Collects the changes of the lamps that have params of their own: the strongest three. */
export function lampChanges(params: NodeContext<typeof definition>['params']): readonly LampChange[] {
  return ([1, 2, 3] as const).map((n) => ({
    pinned: params[`lamp${n}Pinned`],
    azimuthRad: params[`lamp${n}AzimuthRad`],
    elevationRad: params[`lamp${n}ElevationRad`],
    kind: params[`lamp${n}Kind`],
    distanceM: params[`lamp${n}DistanceM`],
  }));
}

/** The kind of a lamp: its own if it has one, otherwise that of all lamps. */
export function kindOf(all: number, change: LampChange | undefined): LampKind {
  const own = change ? choiceIndex(change.kind.value, KINDS.length + 1) : 0;
  return KINDS[own > 0 ? own - 1 : choiceIndex(all, KINDS.length)] ?? 'directional';
}
