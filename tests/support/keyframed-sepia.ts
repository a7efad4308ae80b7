import type { GraphText } from './open-editor.ts';

interface Key {
  readonly timeS: number;
  readonly value: number;
  readonly easing?: string;
}

/** A Sepia node whose amount follows these keyframes once. */
export function keyframedSepia(...keys: readonly Key[]): GraphText['nodes'][string] {
  return { type: 'filter/sepia', params: { amount: { track: { repeat: 'once', keys } } } };
}
