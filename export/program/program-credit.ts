/** A work and its license. */
export interface ProgramCredit {
  /** An effect's title, or the project path of an asset. */
  readonly title: string;
  readonly kind: 'effect' | 'asset';
  /** The author; empty if none is named. */
  readonly credit: string;
  /** Empty if none is named; effects of Scrim's own library are under Scrim's license. */
  readonly licence: string;
  /** Ids of the nodes that use it. */
  readonly nodes: readonly string[];
}
