import { refusal } from '../file-errors.ts';
import { COLMAP } from '../outside/outside-tools.ts';
import { runTool } from '../outside/run-tool.ts';

type OnLine = (line: string) => void;

/** The COLMAP of this machine. */
export interface Colmap {
  /** Such as `3.8`. */
  readonly version: string;
  /** Whether it was built with CUDA. */
  readonly hasCuda: boolean;
  /** Whether it has CUDA, and no command has failed on the graphics card so far. */
  readonly usesGpu: boolean;
  /** Runs a command. @returns What it prints. */
  run(args: readonly string[], onLine?: OnLine): Promise<readonly string[]>;
  /**
   * Runs a command that can use the graphics card: on it where COLMAP has CUDA, and again without where that fails, as where there is no card.
   *
   * @param groups Groups of options that may have the switch: COLMAP 3.12 renamed them.
   */
  runOnGpu(args: readonly string[], groups: readonly string[], onLine?: OnLine): Promise<void>;
}

/** Programs that are not COLMAP may wait for input. */
const ANSWER_MS = 20_000;

/**
 * Asks COLMAP what it is.
 *
 * @param path Of its executable file.
 * @param log File for what it prints; null: none.
 * @throws SCR078 if the file is something else
 */
export async function openColmap(path: string, log: string | null, interrupted: AbortSignal, onLine: OnLine = () => {}): Promise<Colmap> {
  const help = await runTool({ tool: path, args: ['help'], log: null, limitMs: ANSWER_MS, onLine: () => {}, interrupted });
  const version = help.map((line) => /^\s*COLMAP (\d[\w.-]*)/.exec(line)?.[1]).find((text) => text !== undefined);
  if (version === undefined)
    throw refusal('SCR078', `${path} is not COLMAP.`, `Name the executable file of COLMAP, or get it: ${COLMAP.url}`);
  const hasCuda = help.some((line) => /with CUDA/i.test(line));
  let usesGpu = hasCuda;
  const run: Colmap['run'] = (args, ownLine = () => {}) =>
    runTool({
      tool: path,
      args,
      log,
      interrupted,
      onLine: (line) => {
        onLine(line);
        ownLine(line);
      },
    });
  return {
    version,
    hasCuda,
    get usesGpu() {
      return usesGpu;
    },
    run,
    runOnGpu: async (args, groups, ownLine) => {
      const known = (await runTool({ tool: path, args: [args[0] ?? '', '-h'], log: null, onLine: () => {}, interrupted })).join('\n');
      const group = groups.find((each) => known.includes(`--${each}.use_gpu`));
      const runWith = (gpu: boolean) => run([...args, ...(group === undefined ? [] : [`--${group}.use_gpu`, gpu ? '1' : '0'])], ownLine);
      if (usesGpu && group !== undefined) {
        try {
          await runWith(true);
          return;
        } catch (error) {
          interrupted.throwIfAborted();
          onLine(error instanceof Error ? error.message : String(error));
          usesGpu = false;
        }
      }
      await runWith(false);
    },
  };
}
