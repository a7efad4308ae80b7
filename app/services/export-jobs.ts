import type { HostOutput } from '../contract/contract.ts';
import { type ExportJob, exportProject } from './export-project.ts';

/** Exports in progress, one per open project. */
export interface ExportJobs {
  /** Starts an export. Cancels an earlier one of the same project, whose window was reloaded. */
  run(projectId: string, job: Omit<ExportJob, 'interrupted'>): Promise<HostOutput<'export.run'>>;
  /** Cancels an export and removes its files; `run` then resolves. */
  cancel(projectId: string): void;
  dispose(): void;
}

export function createExportJobs(): ExportJobs {
  const running = new Map<string, AbortController>();
  return {
    run: async (projectId, job) => {
      running.get(projectId)?.abort();
      const mine = new AbortController();
      running.set(projectId, mine);
      try {
        const { report, diagnostics } = await exportProject({ ...job, interrupted: mine.signal });
        return { ok: report !== null, out: job.out, diagnostics: [...diagnostics], bytes: report?.bytes.raw ?? 0 };
      } catch (error) {
        if (error !== mine.signal.reason || !mine.signal.aborted) throw error;
        return { ok: false, out: job.out, diagnostics: [], bytes: 0 };
      } finally {
        if (running.get(projectId) === mine) running.delete(projectId);
      }
    },
    cancel: (projectId) => running.get(projectId)?.abort(),
    dispose: () => {
      for (const job of running.values()) job.abort();
    },
  };
}
