/** Context that `tools/run.mjs` passes to each tool. */
export interface ToolContext {
  /** Absolute path of the repository. */
  readonly root: string;
  /** Hash of the code of the tool and all of its dependencies. */
  readonly version: string;
}

/** The `main` function of a tool. Returns the exit status. */
export type ToolMain = (args: readonly string[], context: ToolContext) => Promise<number>;
