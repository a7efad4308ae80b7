/** Why the compiler leaves out a node that the output depends on. `scrim plan --why` and the inspector show the texts. */
export const FOLD_REASONS = {
  constant: 'its values are the same in every frame, so the nodes that read them contain them',
  equal: 'another node computes the same',
  unchanged: 'with its parameters it changes nothing',
  unread: 'only nodes that are left out need it',
} as const;

export type FoldReason = keyof typeof FOLD_REASONS;

/** A node that is left out of the program. */
export interface FoldedNode {
  readonly node: string;
  readonly reason: FoldReason;
  /** The node that computes the same, or whose layer is shown instead; null if there is none. */
  readonly instead: string | null;
}
