import type { ExportReport } from '../../export/bundle/report.ts';
import type { ExportedReport, HostOutput } from '../contract/contract.ts';
import { type ExportJob, exportProject } from './export-project.ts';

/** Exports in progress, one per open project. */
export interface ExportJobs {
  /** Starts an export. Cancels an earlier one of the same project, whose window was reloaded. */
  run(projectId: string, job: Omit<ExportJob, 'interrupted'>): Promise<HostOutput<'export.run'>>;
  /** Folder of the page that a project was exported to last; null if there is none. */
  lastOf(projectId: string): string | null;
  /** Cancels an export and removes its files; `run` then resolves. */
  cancel(projectId: string): void;
  dispose(): void;
}

export function createExportJobs(): ExportJobs {
  const running = new Map<string, AbortController>();
  const last = new Map<string, string>();
  return {
    lastOf: (projectId) => last.get(projectId) ?? null,
    run: async (projectId, job) => {
      running.get(projectId)?.abort();
      const mine = new AbortController();
      running.set(projectId, mine);
      try {
        const { report, diagnostics } = await exportProject({ ...job, interrupted: mine.signal });
        if (report !== null) last.set(projectId, job.out);
        return { ok: report !== null, out: job.out, diagnostics: [...diagnostics], report: report && extractOf(report) };
      } catch (error) {
        if (error !== mine.signal.reason || !mine.signal.aborted) throw error;
        return { ok: false, out: job.out, diagnostics: [], report: null };
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

function extractOf({ files, bytes, assets, gpuBytes: pageGpuBytes, note, devices }: ExportReport): ExportedReport {
  const { byKind, raw, gzip } = bytes;
  return {
    files: files.length,
    bytes: { raw, gzip },
    assets: assets.map(({ source, fileBytes, gpuBytes, reducedOnPhones = [] }) => ({
      path: source,
      bytes: fileBytes.after,
      gpuBytes: gpuBytes.after,
      phoneGpuBytes: gpuBytes.onPhones ?? null,
      reducedOnPhones: [...reducedOnPhones],
    })),
    gpuBytes: pageGpuBytes,
    parts: Object.entries(byKind)
      .map(([kind, sizes]) => ({ kind, ...sizes }))
      .sort((a, b) => b.gzip - a.gzip),
    note,
    devices: devices.map(({ title, tier, display, worthless, lost, unseen }) => ({
      title,
      tier,
      display,
      worthless,
      lost: lost.map(({ node, capability, effect, fact }) => ({ node, capability, effect, known: fact.has === 'no' })),
      unseen: [...unseen],
    })),
  };
}
