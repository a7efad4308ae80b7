import type { HostOutput } from '../contract/contract.ts';
import { type ExportJob, exportProject } from './export-project.ts';

/** The exports under way, one for each open project. */
export interface ExportJobs {
  /** Ends the one before of the same project, whose window was reloaded meanwhile. */
  run(handle: string, job: Omit<ExportJob, 'interrupted'>): Promise<HostOutput<'export.run'>>;
  /** What is written by then is taken back, and `run` answers. */
  cancel(handle: string): void;
  dispose(): void;
}

export function createExportJobs(): ExportJobs {
  const running = new Map<string, AbortController>();
  return {
    run: async (handle, job) => {
      running.get(handle)?.abort();
      const mine = new AbortController();
      running.set(handle, mine);
      try {
        const { report, diagnostics } = await exportProject({ ...job, interrupted: mine.signal });
        return { ok: report !== null, out: job.out, diagnostics: [...diagnostics], bytes: report?.bytes.raw ?? 0 };
      } catch (error) {
        if (error !== mine.signal.reason || !mine.signal.aborted) throw error;
        return { ok: false, out: job.out, diagnostics: [], bytes: 0 };
      } finally {
        if (running.get(handle) === mine) running.delete(handle);
      }
    },
    cancel: (handle) => running.get(handle)?.abort(),
    dispose: () => {
      for (const job of running.values()) job.abort();
    },
  };
}
