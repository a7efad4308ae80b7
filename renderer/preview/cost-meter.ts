import type { Operation } from '../../export/program/program.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import type { MemoryCost, OperationCost } from '../preview-costs.ts';
import type { FromPreview } from '../preview-protocol.ts';

/** Measures operations: number of draw calls, and GPU time if the browser supports timer queries. */
export interface CostMeter {
  begin(operation: Operation): void;
  end(): void;
  setOn(on: boolean): void;
  afterFrame(): void;
  dispose(): void;
}

const INTERVAL_S = 0.5;
const DRAWS = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced', 'drawRangeElements'] as const;

/** The used part of EXT_disjoint_timer_query_webgl2, which TypeScript’s DOM library lacks. */
interface TimerQuery {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/**
 * Wraps the draw functions of the context while it is on, so that draw calls of three.js count as well. Timer queries must not
 * overlap, so each operation of a frame has its own query. Results arrive some frames later; the next frame is timed only then.
 */
export function createCostMeter(
  gl: WebGL2RenderingContext,
  clock: Pick<FrameClock, 'nowS'>,
  send: (message: FromPreview) => void,
  owners: () => readonly MemoryCost[],
): CostMeter {
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerQuery | null;
  let on = false;
  let current: { draws: number } | null = null;
  let sentS = Number.NEGATIVE_INFINITY;
  const counts = new Map<string, { draws: number }>();
  let gpuMsById = new Map<string, number>();
  let queries: { readonly id: string; readonly query: WebGLQuery }[] = [];
  /** Whether the current frame is timed. */
  let timing = false;
  let running = false;

  const wrapDraws = () => {
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
  const unwrapDraws = () => {
    for (const name of DRAWS) Reflect.deleteProperty(gl, name);
  };
  const deleteQueries = () => {
    for (const { query } of queries) gl.deleteQuery(query);
    queries = [];
  };
  const collect = () => {
    const last = queries.at(-1);
    if (!timer || !last || gl.getQueryParameter(last.query, gl.QUERY_RESULT_AVAILABLE) !== true) return;
    if (gl.getParameter(timer.GPU_DISJOINT_EXT) !== true) {
      gpuMsById = new Map();
      for (const { id, query } of queries)
        gpuMsById.set(id, (gpuMsById.get(id) ?? 0) + Number(gl.getQueryParameter(query, gl.QUERY_RESULT)) / 1e6);
    }
    deleteQueries();
  };
  return {
    setOn: (next) => {
      if (next === on) return;
      on = next;
      if (on) wrapDraws();
      else unwrapDraws();
      timing = on && timer !== null;
      counts.clear();
      gpuMsById = new Map();
      deleteQueries();
    },
    begin: ({ id }) => {
      if (!on) return;
      current = counts.get(id) ?? { draws: 0 };
      counts.set(id, current);
      const query = timing ? gl.createQuery() : null;
      if (!timer || !query) return;
      gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
      queries.push({ id, query });
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
      timing = timer !== null && queries.length === 0;
      const nowS = clock.nowS();
      if (nowS - sentS >= INTERVAL_S) {
        sentS = nowS;
        const costs = [...counts].map(([id, { draws }]): OperationCost => ({ id, draws, gpuMs: gpuMsById.get(id) ?? null }));
        send({ kind: 'costs', costs, memory: owners() });
      }
      counts.clear();
    },
    dispose: () => {
      if (on) unwrapDraws();
      deleteQueries();
    },
  };
}
