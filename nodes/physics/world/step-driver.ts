import type { NodeWorker, WorkerService } from '../../kit/runtime.ts';
import { depthOf, type PhysicsCommand, POSE_STRIDE, type StepAnswer, type StepMessage, TOUCH_STRIDE } from './protocol.ts';

/** Sends steps to an engine in a worker. If no worker starts, it runs the engine on the main thread. */
export interface StepDriver {
  /** True if no step is running: the last one has been answered. */
  readonly isIdle: boolean;
  readonly isOnMainThread: boolean;
  /** Starts a step. Call it only while idle. The driver does not keep `commands` after the call. */
  send(commands: readonly PhysicsCommand[], deltaS: number, bodyCount: number, wants?: Wants): void;
  /** Returns the newest answer once; null if there is no new one. Valid until the next `send`. */
  take(): StepAnswer | null;
  /** Resolves when the running step is answered; null while idle. */
  settle(): Promise<void> | null;
  /** Makes the driver drop the answer of the running step. */
  forget(): void;
  /** Gives up a worker that has not answered for too long. Call it once per frame. */
  watch(): void;
  dispose(): void;
}

/** What a step shall give besides poses and contacts. */
export interface Wants {
  readonly voxels: boolean;
  readonly file: boolean;
}

export interface DriverOptions {
  readonly workers: WorkerService;
  /** Creates the engine for the main thread. */
  readonly createStepper: () => (message: StepMessage) => StepAnswer;
  /** Returns the commands that bring a new engine to the state after the last answer. */
  readonly restore: () => readonly PhysicsCommand[];
  /**
   * Called when a worker has ended with an error or was given up; another one repeats the running step, or the main thread if
   * `isOnMainThread`.
   */
  readonly onRestart: (reason: string, isOnMainThread: boolean) => void;
}

/** After this many workers have failed, steps run on the main thread. */
const MAX_WORKERS = 3;
/** Number of frames after which a worker that has not answered is given up. */
const PATIENCE_FRAMES = 300;
const TOUCHES = 128;
const NOTHING: Wants = { voxels: false, file: false };

export function createStepDriver({ workers, createStepper, restore, onRestart }: DriverOptions): StepDriver {
  let worker: NodeWorker | null = null;
  let onMain: ((message: StepMessage) => StepAnswer) | null = null;
  let started = 0;
  let poses = new Float32Array(0);
  let touches = new Float32Array(TOUCH_STRIDE * TOUCHES);
  let arrived: StepAnswer | null = null;
  /** The running step, to repeat it if its worker fails. */
  let inWork: { readonly commands: readonly PhysicsCommand[]; readonly deltaS: number; readonly bodyCount: number } | null = null;
  let isForgotten = false;
  let framesAway = 0;
  const waiting: (() => void)[] = [];
  const transfer: ArrayBuffer[] = [];

  const finish = (answer: StepAnswer): void => {
    inWork = null;
    poses = answer.poses;
    touches = answer.touches;
    arrived = isForgotten ? null : answer;
    isForgotten = false;
    for (const wake of waiting.splice(0)) wake();
  };
  const onAnswer = (answer: StepAnswer): void => {
    if (answer.failure === null) finish(answer);
    else fail(answer.failure);
  };
  function fail(reason: string): void {
    worker?.dispose();
    worker = null;
    const lost = inWork;
    onRestart(reason, started >= MAX_WORKERS);
    if (!lost) return;
    inWork = null;
    poses = new Float32Array(0);
    touches = new Float32Array(TOUCH_STRIDE * TOUCHES);
    // What is in the kept state already has no effect a second time. The buffers of depth may have other content by now.
    const again = lost.commands.filter(({ kind }) => kind !== 'clear' && kind !== 'depth');
    send([...restore(), ...again], lost.deltaS, lost.bodyCount);
  }
  function start(): void {
    if (worker || onMain) return;
    if (started < MAX_WORKERS) {
      started++;
      let current: NodeWorker | null = null;
      try {
        current = workers.start({
          onMessage: (data) => {
            if (worker === current) onAnswer(data as StepAnswer);
          },
          onFailure: (reason) => {
            if (worker === current) fail(reason);
          },
        });
        worker = current;
        return;
      } catch {
        // A browser that starts none now will start none later.
        started = MAX_WORKERS;
      }
    }
    onMain = createStepper();
  }
  function send(commands: readonly PhysicsCommand[], deltaS: number, bodyCount: number, wants = NOTHING): void {
    start();
    const needed = bodyCount * POSE_STRIDE;
    // Twice the room, so that a growing world allocates rarely.
    if (poses.length < needed) poses = new Float32Array(2 * needed);
    inWork = { commands: [...commands], deltaS, bodyCount };
    framesAway = 0;
    const message: StepMessage = { commands, deltaS, poses, touches, wantsVoxels: wants.voxels, wantsFile: wants.file };
    if (onMain) {
      const answer = onMain(message);
      if (answer.failure !== null) throw new Error(`The physics engine failed: ${answer.failure}`);
      finish(answer);
      return;
    }
    transfer.length = 0;
    transfer.push(poses.buffer, touches.buffer);
    for (const command of commands) {
      const depth = depthOf(command);
      if (depth) transfer.push(depth.buffer);
    }
    worker?.post(message, transfer);
  }

  return {
    get isIdle() {
      return inWork === null;
    },
    get isOnMainThread() {
      return onMain !== null;
    },
    send,
    take: () => {
      const answer = arrived;
      arrived = null;
      return answer;
    },
    settle: () => {
      if (inWork === null) return null;
      return new Promise((resolve) => {
        waiting.push(resolve);
      });
    },
    forget: () => {
      arrived = null;
      isForgotten = inWork !== null;
    },
    watch: () => {
      if (inWork !== null && ++framesAway > PATIENCE_FRAMES) fail('its worker does not answer');
    },
    dispose: () => {
      worker?.dispose();
      worker = null;
      inWork = null;
      for (const wake of waiting.splice(0)) wake();
    },
  };
}
