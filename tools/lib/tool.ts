/** What every tool is handed by `tools/run.mjs`. */
export interface ToolContext {
  /** Absolute path of the repository. */
  readonly root: string;
  /** Hash of the tool's own code and all it is bundled from. */
  readonly version: string;
}

/** What a tool's `main` is: it answers with the exit status. */
export type ToolMain = (args: readonly string[], context: ToolContext) => Promise<number>;
