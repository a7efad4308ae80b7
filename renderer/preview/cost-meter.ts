import type { FrameClock } from '../../export/runtime/clock.ts';
import type { OperationTimer } from '../../export/runtime/program-instance/operation-timer.ts';
import type { FromPreview, OperationCost } from '../preview-protocol.ts';

/** What operations cost: how often they draw, and how long the GPU takes where the browser tells. */
export interface CostMeter extends OperationTimer {
  setOn(on: boolean): void;
  afterFrame(): void;
  dispose(): void;
}

const INTERVAL_S = 0.5;
const DRAWS = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced', 'drawRangeElements'] as const;

/** The part of EXT_disjoint_timer_query_webgl2 that is used; TypeScript's library has none. */
interface TimerQuery {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/**
 * Counts by standing before the context's own functions, so that what three.js draws counts too; only while it is on. Timers may not
 * lie within each other, so one operation after the other is timed, all of one frame; the answers are there some frames later, and
 * only then is another frame timed.
 */
export function createCostMeter(
  gl: WebGL2RenderingContext,
  clock: Pick<FrameClock, 'nowS'>,
  send: (message: FromPreview) => void,
): CostMeter {
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerQuery | null;
  let on = false;
  let current: { draws: number } | null = null;
  let sentS = Number.NEGATIVE_INFINITY;
  const counts = new Map<string, { draws: number }>();
  let known = new Map<string, number>();
  let asked: { readonly id: string; readonly query: WebGLQuery }[] = [];
  /** This frame is timed. */
  let timing = false;
  let running = false;

  const standBefore = () => {
    for (const name of DRAWS) {
      const draw = gl[name].bind(gl) as (...args: unknown[]) => void;
      Object.assign(gl, {
        [name]: (...args: unknown[]) => {
          if (current) current.draws++;
          draw(...args);
        },
      });
    }
  };
  const stepAside = () => {
    for (const name of DRAWS) Reflect.deleteProperty(gl, name);
  };
  const forget = () => {
    for (const { query } of asked) gl.deleteQuery(query);
    asked = [];
  };
  const collect = () => {
    const last = asked.at(-1);
    if (!timer || !last || gl.getQueryParameter(last.query, gl.QUERY_RESULT_AVAILABLE) !== true) return;
    if (gl.getParameter(timer.GPU_DISJOINT_EXT) !== true) {
      known = new Map();
      for (const { id, query } of asked) known.set(id, (known.get(id) ?? 0) + Number(gl.getQueryParameter(query, gl.QUERY_RESULT)) / 1e6);
    }
    forget();
  };
  return {
    setOn: (next) => {
      if (next === on) return;
      on = next;
      if (on) standBefore();
      else stepAside();
      timing = on && timer !== null;
      counts.clear();
      known = new Map();
      forget();
    },
    begin: ({ id }) => {
      if (!on) return;
      current = counts.get(id) ?? { draws: 0 };
      counts.set(id, current);
      const query = timing ? gl.createQuery() : null;
      if (!timer || !query) return;
      gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
      asked.push({ id, query });
      running = true;
    },
    end: () => {
      current = null;
      if (running && timer) gl.endQuery(timer.TIME_ELAPSED_EXT);
      running = false;
    },
    afterFrame: () => {
      if (!on) return;
      collect();
      timing = timer !== null && asked.length === 0;
      const nowS = clock.nowS();
      if (nowS - sentS >= INTERVAL_S) {
        sentS = nowS;
        const costs = [...counts].map(([id, { draws }]): OperationCost => ({ id, draws, gpuMs: known.get(id) ?? null }));
        send({ kind: 'costs', costs });
      }
      counts.clear();
    },
    dispose: () => {
      if (on) stepAside();
      forget();
    },
  };
}
