import { GATE_SAMPLER, GATE_UNIFORM, PROBE_SIDE_PX } from '../../program/loop-budget.ts';
import type { Asker, LoopProbe } from '../gl/loop-probe.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { Drawing, Gate } from './drawing.ts';

/**
 * Decides whether a pass is drawn or only copies its input, because loops of its node exceed their budget
 * (`export/program/loop-budget.ts`).
 */
export interface PassGuard {
  /**
   * Whether loops of the node exceed their budget, in this pass or another pass of the node. All passes of the node then copy their first
   * input.
   */
  readonly bypassed: boolean;
  /** What a pass with loops needs for its probe; null for a pass without loops. */
  readonly loops: {
    readonly probe: LoopProbe;
    /** A linked program: `COPY_SHADER` with a gate. */
    readonly gatedCopy: GlProgram;
    readonly asker: Asker;
    /** Whether to probe the loops in this frame. */
    readonly due: boolean;
  } | null;
}

/** Values of the gate uniform in bounded shaders, see `export/program/loop-budget.ts`. */
const GATE = { open: 0, unlessExceeded: 1, ifExceeded: 2 } as const;

interface LiveGate extends Gate {
  value: (typeof GATE)[keyof typeof GATE];
}

export function createGate(gl: WebGL2RenderingContext, drawer: PassDrawer, { probe }: NonNullable<PassGuard['loops']>): LiveGate {
  const gate: LiveGate = {
    value: GATE.open,
    setterFor: (program, unit) => {
      const uniform = program.uniform(GATE_UNIFORM);
      const sampler = program.uniform(GATE_SAMPLER);
      return () => {
        if (uniform) gl.uniform1i(uniform, gate.value);
        // The probe must not be bound for reading while it is drawn.
        if (sampler) drawer.texture(unit, sampler, gate.value === GATE.open ? null : probe.texture, 'nearest');
      };
    },
  };
  return gate;
}

/** Makes a pass draw or copy its first input, as its guard decides. */
export function guardDrawing(own: Drawing, handOn: Drawing, guard: PassGuard, gate: LiveGate | null, drawer: PassDrawer): Drawing {
  const { loops } = guard;
  if (loops === null || gate === null) {
    return { prepare: own.prepare, draw: (state, widthPx, heightPx) => (guard.bypassed ? handOn : own).draw(state, widthPx, heightPx) };
  }
  return {
    prepare: own.prepare,
    probe: (state, widthPx, heightPx) => {
      if (!loops.due) return;
      drawer.begin(loops.probe.framebuffer, 0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, 'replace');
      loops.probe.clear();
      gate.value = GATE.open;
      own.draw(state, widthPx, heightPx);
      loops.probe.ask(loops.asker);
      drawer.end();
    },
    draw: (state, widthPx, heightPx) => {
      if (guard.bypassed) {
        gate.value = GATE.open;
        handOn.draw(state, widthPx, heightPx);
        return;
      }
      // The gate lets one of the two draw, which only the GPU can decide without waiting.
      gate.value = GATE.ifExceeded;
      handOn.draw(state, widthPx, heightPx);
      gate.value = GATE.unlessExceeded;
      own.draw(state, widthPx, heightPx);
    },
  };
}
