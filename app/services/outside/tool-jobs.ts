import type { HostEvent } from '../../contract/contract.ts';

/** Runs of programs of others for the editor, one at a time per open project. */
export interface ToolJobs {
  /** Runs a task. Cancels an earlier one of the same project, and awaits its end. */
  run<T>(projectId: string, client: string, job: ToolJob<T>): Promise<T>;
  /** Ends the program. */
  cancel(projectId: string): void;
  /** Cancels the runs of a closed window or tab. */
  left(client: string): void;
  dispose(): void;
}

export interface ToolJob<T> extends Pick<ToolEvents, 'onLines'> {
  /** The result of a run that was canceled. */
  readonly canceled: T;
  readonly task: (interrupted: AbortSignal, onLine: (line: string) => void) => Promise<T>;
}

/** What the editor shows of a run. */
export interface ToolEvents {
  readonly onProgress: (progress: Pick<Extract<HostEvent, { kind: 'tool-progress' }>, 'step' | 'text'>) => void;
  /** Receives what the program prints, some lines at a time. */
  readonly onLines: (lines: string[]) => void;
}

interface Running {
  readonly client: string;
  readonly canceled: AbortController;
  ended: Promise<unknown>;
}

/** Programs print thousands of lines. */
const LINES_MS = 150;
/** More lines at a time than anybody reads are in the log file. */
const MOST_LINES = 200;

export function createToolJobs(): ToolJobs {
  const running = new Map<string, Running>();
  const cancel = (projectId: string): void => running.get(projectId)?.canceled.abort();
  return {
    run: async (projectId, client, { onLines, canceled, task }) => {
      const earlier = running.get(projectId)?.ended;
      cancel(projectId);
      const mine: Running = { client, canceled: new AbortController(), ended: Promise.resolve() };
      running.set(projectId, mine);
      const interrupted = mine.canceled.signal;
      const lines = batched(onLines);
      const work = async () => {
        await earlier;
        interrupted.throwIfAborted();
        return task(interrupted, lines.add);
      };
      const done = work();
      mine.ended = done.catch(() => {});
      try {
        return await done;
      } catch (error) {
        if (interrupted.aborted) return canceled;
        throw error;
      } finally {
        lines.end();
        if (running.get(projectId) === mine) running.delete(projectId);
      }
    },
    cancel,
    left: (client) => {
      for (const [projectId, job] of running) if (job.client === client) cancel(projectId);
    },
    dispose: () => {
      for (const projectId of running.keys()) cancel(projectId);
    },
  };
}

/** Collects lines, so that few events carry them. */
function batched(send: (lines: string[]) => void) {
  let lines: string[] = [];
  let timer: NodeJS.Timeout | null = null;
  const flush = (): void => {
    timer = null;
    if (lines.length > 0) send(lines.slice(-MOST_LINES));
    lines = [];
  };
  return {
    add: (line: string): void => {
      lines.push(line);
      timer ??= setTimeout(flush, LINES_MS);
    },
    end: (): void => {
      if (timer !== null) clearTimeout(timer);
      flush();
    },
  };
}
