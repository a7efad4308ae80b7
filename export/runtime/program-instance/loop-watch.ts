import { LOOP_BUDGET_UNIFORM, tooManyIterations } from '../../program/loop-budget.ts';
import type { LinkedShader, PassOperation } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { GATED_COPY_SHADER } from '../gl/gated-copy-shader.ts';
import { createLoopProbe, type LoopProbe } from '../gl/loop-probe.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { LoadedProgram } from '../loading.ts';
import type { PassGuard } from '../passes/guarded-drawing.ts';

/**
 * Tracks which nodes of a program exceed the loop budget. A node that exceeds it and whose loops may never end is bypassed until a probe
 * finds that its loops end.
 */
export interface LoopWatch {
  /** The guard of a pass; null if its node has no bounded loops. */
  guardOf(operation: PassOperation): PassGuard | null;
  /** Receives results of probes. Called before each frame. */
  poll(): void;
  /** Called when a param changes: passes that exceeded the budget are probed again. */
  retry(): void;
  /**
   * The author's line at which a pass exceeded the budget; null if it did not, or if the pass now has another GL program. The watch of the
   * next program takes it over.
   */
  lineOf(operation: PassOperation, glProgram: GlProgram): number | null;
  isBypassed(node: string): boolean;
  /** Whether a diagnostic about the node's loops is reported. */
  isTold(node: string): boolean;
  /** Clears the diagnostics of nodes that `next` does not report. */
  release(next: LoopWatch | null): void;
}

interface WatchedPass {
  readonly operation: PassOperation;
  readonly glProgram: GlProgram;
  readonly shader: LinkedShader | undefined;
  /** The author's line of the loop that used the last iteration of the budget; null if none did. */
  line: number | null;
  /** Whether the pass is probed although its node is bypassed, because a param has changed. */
  onTrial: boolean;
}

/**
 * Watches programs whose loops are bounded (`export/program/loop-budget.ts`). Hosts that compile with a loop budget pass
 * `createLoopGuard` to the player; exported pages have no bounded loops and do not bundle it.
 */
export interface LoopGuard {
  /** Creates the watch of a program; null if it has no bounded loops. `before` is the watch of the program that is replaced. */
  watch(loaded: LoadedProgram, before: LoopWatch | null): LoopWatch | null;
  dispose(): void;
}

/** Creates the loop guard of an engine. It creates the probe for the first program with bounded loops and keeps it for later ones. */
export function createLoopGuard(engine: Engine): LoopGuard {
  let probe: LoopProbe | null = null;
  const probeOf = (): LoopProbe => {
    probe ??= createLoopProbe(engine.objects);
    return probe;
  };
  return {
    watch: (loaded, before) => createLoopWatch(engine, probeOf, loaded, before),
    dispose: () => probe?.dispose(),
  };
}

function createLoopWatch(
  engine: Engine,
  probeOf: () => LoopProbe,
  { program, glPrograms }: LoadedProgram,
  before: LoopWatch | null,
): LoopWatch | null {
  const { board } = engine.host;
  const byNode = new Map<string, WatchedPass[]>();
  let released = false;
  const isTold = (node: string): boolean => byNode.get(node)?.some(({ line }) => line !== null) ?? false;
  const isBypassed = (node: string): boolean =>
    byNode.get(node)?.some(({ line, shader }) => line !== null && shader?.loops !== 'counted') ?? false;
  const settle = (pass: WatchedPass, line: number | null): void => {
    pass.onTrial = false;
    if (released || line === pass.line) return;
    const { node } = pass.operation;
    pass.line = line;
    board.clear(node);
    for (const watched of byNode.get(node) ?? []) {
      if (watched.line !== null) board.report(node, tooManyIterations(watched.shader, watched.line));
    }
  };

  for (const operation of program.operations) {
    if (operation.kind !== 'pass') continue;
    const glProgram = glPrograms[operation.shader];
    if (glProgram?.state !== 'linked' || glProgram.uniform(LOOP_BUDGET_UNIFORM) === null) continue;
    const line = before?.lineOf(operation, glProgram) ?? null;
    const pass: WatchedPass = { operation, glProgram, shader: program.shaders[operation.shader], line, onTrial: false };
    const passes = byNode.get(operation.node);
    if (passes) passes.push(pass);
    else byNode.set(operation.node, [pass]);
  }
  if (byNode.size === 0) return null;
  const probe = probeOf();
  const gatedCopy = engine.tool(GATED_COPY_SHADER);
  const passOf = ({ id, node }: PassOperation): WatchedPass | undefined => byNode.get(node)?.find(({ operation }) => operation.id === id);

  return {
    isBypassed,
    isTold,
    poll: probe.poll,
    guardOf: (operation) => {
      const { node } = operation;
      if (!byNode.has(node)) return null;
      const pass = passOf(operation);
      const loops = pass && {
        probe,
        gatedCopy,
        asker: { round: 0, answer: (line: number | null) => settle(pass, line) },
        get due() {
          return pass.onTrial || !isBypassed(node);
        },
      };
      return {
        get bypassed() {
          return isBypassed(node);
        },
        loops: loops ?? null,
      };
    },
    retry: () => {
      for (const passes of byNode.values()) for (const pass of passes) pass.onTrial = pass.line !== null;
    },
    lineOf: (operation, glProgram) => {
      const pass = passOf(operation);
      return pass?.glProgram === glProgram ? pass.line : null;
    },
    release: (next) => {
      released = true;
      for (const node of byNode.keys()) if (isTold(node) && !next?.isTold(node)) board.clear(node);
    },
  };
}
