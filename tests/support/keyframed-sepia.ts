import type { GraphText } from './open-editor.ts';

interface Key {
  readonly timeS: number;
  readonly value: number;
  readonly easing?: string;
}

/** A sepia that gets browner and paler by these keys, once. */
export function keyframedSepia(...keys: readonly Key[]): GraphText['nodes'][string] {
  return { type: 'filter/sepia', params: { amount: { track: { repeat: 'once', keys } } } };
}
