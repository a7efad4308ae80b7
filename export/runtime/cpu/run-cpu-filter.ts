import type { CpuAnswer, WorkerModule } from '../../../nodes/kit/cpu-filter.ts';
import { IDENTITY } from '../../../nodes/kit/matrices.ts';
import type { NodeContext, NodeRuntime, NodeWorker } from '../../../nodes/kit/runtime.ts';
import type { FrameClock } from '../clock.ts';
import { COPY_SAMPLER, COPY_UV } from '../gl/copy-shader.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import { MAX_VIEWS } from '../targets/target.ts';
import type { TargetBuffer } from '../targets/target-buffer.ts';
import { createViewExchange } from './view-exchange.ts';
import type { StartWorker } from './worker-source.ts';

/** Plays a node whose pixels are computed by a worker (ADR 21). */
export interface CpuFilter extends NodeRuntime {
  /** The number of results that have been shown, in any view; each input that is shown after a failure counts. */
  readonly shown: number;
  /** Called once per view and frame: draws the last result, or the input if there is none, and sends the input if the worker is idle. */
  exchange(viewIndex: number, image: TargetBuffer, into: TargetBuffer): void;
}

/** What a CPU filter needs of the engine. */
export interface CpuMeans {
  readonly objects: GlObjects;
  readonly drawer: PassDrawer;
  /** The linked program that copies an image. */
  readonly copy: GlProgram;
  readonly clock: FrameClock;
  readonly startWorker: StartWorker;
}

export interface CpuNode {
  readonly id: string;
  /** Current values of the uniform params. */
  readonly params: Readonly<Record<string, { readonly value: unknown }>>;
  /** Values of the structure params. */
  readonly config: Readonly<Record<string, unknown>>;
  /** Whether frames wait for their result, as in a render. */
  readonly held: boolean;
  readonly report: NodeContext<never>['report'];
}

/** Interval for polling the GPU between frames, about the shortest that browsers' timers support. */
const POLL_S = 0.004;
/** How long to wait for the answer of a worker before the filter fails: in frames, or in a render in seconds. */
const PATIENCE_FRAMES = 600;
const PATIENCE_S = 30;

export function createCpuFilter({ worker: text }: WorkerModule, node: CpuNode, means: CpuMeans): CpuFilter {
  const { objects, drawer, copy, clock, startWorker } = means;
  const views = Array.from({ length: MAX_VIEWS }, () => ({ exchange: createViewExchange(objects), framesAway: 0 }));
  const params = Object.entries(node.params);
  const values: Record<string, unknown> = { ...node.config };
  const transfer: ArrayBuffer[] = [];
  const task = { view: 0, turn: 0, buffer: new ArrayBuffer(0), widthPx: 0, heightPx: 0, params: values };
  let worker: NodeWorker | null = null;
  /** Whether the filter failed or was disposed. The input is then passed through. */
  let ended = false;
  /** Number of resets. Results of tasks from before the last reset are dropped. */
  let turn = 0;
  let shown = 0;
  let polling = false;
  const waiting: (() => void)[] = [];

  const isAway = (): boolean => !ended && views.some(({ exchange }) => exchange.state === 'away');
  const wakeAll = (): void => {
    if (isAway()) return;
    for (const wake of waiting.splice(0)) wake();
  };
  const end = (): void => {
    ended = true;
    worker?.dispose();
    worker = null;
    for (const { exchange } of views) exchange.forget();
    wakeAll();
  };
  const fail = (reason: string): void => {
    if (ended) return;
    end();
    node.report({
      code: 'SCR047',
      severity: 'warning',
      message: `The effect ${node.id} failed on the CPU, so its input is drawn unchanged: ${reason}.`,
      fix: 'Load the page again. If that does not help, leave the effect out.',
    });
  };
  const onAnswer = ({ view, turn: itsTurn, buffer, failure }: CpuAnswer): void => {
    if (ended) return;
    if (failure !== null) {
      fail(failure);
      return;
    }
    views[view]?.exchange.giveBack(buffer, itsTurn === turn);
    wakeAll();
  };
  const send = (viewIndex: number, wait: boolean): void => {
    const view = views[viewIndex];
    const bytes = ended ? null : view?.exchange.collect(wait);
    if (!view || !bytes) return;
    view.framesAway = 0;
    task.view = viewIndex;
    task.turn = turn;
    task.buffer = bytes.buffer;
    task.widthPx = bytes.widthPx;
    task.heightPx = bytes.heightPx;
    for (const [name, view] of params) values[name] = view.value;
    try {
      worker ??= startWorker(text, { onMessage: (data) => onAnswer(data as CpuAnswer), onFailure: fail });
      transfer[0] = task.buffer;
      worker.post(task, transfer);
    } catch (error) {
      fail(error instanceof Error ? error.message : String(error));
    }
  };
  const poll = (): void => {
    polling = false;
    if (ended) return;
    for (let i = 0; i < views.length; i++) {
      send(i, false);
      if (views[i]?.exchange.state === 'reading') pollSoon();
    }
  };
  function pollSoon(): void {
    if (!polling) void clock.delay(POLL_S).then(poll);
    polling = true;
  }
  const draw = (texture: WebGLTexture, into: TargetBuffer): void => {
    drawer.begin(into.framebuffer, 0, 0, into.widthPx, into.heightPx, 'replace');
    drawer.use(copy);
    const location = copy.uniform(COPY_SAMPLER);
    if (location) drawer.texture(0, location, texture, 'linear');
    objects.gl.uniformMatrix3fv(copy.uniform(COPY_UV), false, IDENTITY);
    drawer.draw();
    drawer.end();
  };
  const giveUp = (): void => fail('its worker does not answer');
  return {
    get shown() {
      return shown;
    },
    update: () => {},
    exchange: (viewIndex, image, into) => {
      const view = views[viewIndex];
      if (!view) return;
      const { exchange } = view;
      send(viewIndex, false);
      if (exchange.state === 'away' && ++view.framesAway > PATIENCE_FRAMES) giveUp();
      if (ended || exchange.state === 'back') shown++;
      const result = exchange.show();
      if (!ended && exchange.state === 'idle') {
        exchange.read(image);
        if (node.held) send(viewIndex, true);
        else pollSoon();
      }
      draw(result ?? image.color, into);
    },
    settle: () => {
      if (!isAway()) return null;
      const answered = new Promise<void>((resolve) => {
        waiting.push(resolve);
      });
      const patience = clock.delay(PATIENCE_S).then(() => {
        if (isAway()) giveUp();
      });
      return Promise.race([answered, patience]);
    },
    reset: () => {
      turn++;
      for (const { exchange } of views) exchange.forget();
    },
    dispose: () => {
      end();
      for (const { exchange } of views) exchange.dispose();
    },
  };
}
