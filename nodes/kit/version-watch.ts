/** Detects whether lists such as `ObjectList` or `LightList` have changed since the last call. */
export interface VersionWatch {
  /**
   * Whether the lists, their number or their versions differ from those of the previous call.
   *
   * @returns True at the first call.
   */
  changed(lists: readonly Versioned[]): boolean;
}

interface Versioned {
  readonly version: number;
}

/**
 * Creates a watch for the lists of an input.
 *
 * @example
 * const watch = createVersionWatch();
 * // Every frame:
 * if (watch.changed(ctx.inputs.objects)) rebuild();
 */
export function createVersionWatch(): VersionWatch {
  let seen: readonly Versioned[] | null = null;
  const versions: number[] = [];

  function isSame(lists: readonly Versioned[]): boolean {
    if (lists.length !== seen?.length) return false;
    for (let i = 0; i < lists.length; i++) {
      if (lists[i] !== seen[i] || lists[i]?.version !== versions[i]) return false;
    }
    return true;
  }

  return {
    changed: (lists) => {
      if (isSame(lists)) return false;
      seen = [...lists];
      versions.length = 0;
      for (const list of lists) versions.push(list.version);
      return true;
    },
  };
}
