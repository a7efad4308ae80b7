import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { type ExportJob, exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { findProject, readProjectFiles } from '../../app/services/project-files.ts';
import { type ProjectText, projectText, writeProject } from './project-kit.ts';
import { serveStatic } from './serve.ts';

const INSTALLATION = installationAt(resolve(import.meta.dirname, '../..'), '0.0.0');

export interface ServedExport {
  /** Ends in `/`. */
  readonly url: string;
  readonly folder: string;
  close(): Promise<void>;
}

/** Exports a project folder like `scrim export`, and serves the page like a static host. */
export async function serveProject(project: string, more: Partial<ExportJob> = {}): Promise<ServedExport> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-xr-'));
  const folder = join(base, 'page');
  const root = await findProject(project);
  const job = { root, projectFiles: await readProjectFiles(root), out: folder, installation: INSTALLATION, ...more };
  const { report, diagnostics } = await exportProject(job);
  if (report === null) throw new Error(JSON.stringify(diagnostics, null, 2));
  const server = await serveStatic({ '/page/': `${folder}/` });
  return {
    url: `${server.origin}/page/`,
    folder,
    close: async () => {
      await server.close();
      await rm(base, { recursive: true, force: true });
    },
  };
}

/** Exports and serves a project given as data. */
export async function serveProjectText(
  text: ProjectText,
  files: Readonly<Record<string, Uint8Array>>,
  more: Partial<ExportJob> = {},
): Promise<ServedExport> {
  const project = await mkdtemp(join(tmpdir(), 'scrim-xr-project-'));
  await writeProject(project, { 'project.scrim.json': projectText(text), ...files });
  const served = await serveProject(project, more);
  await rm(project, { recursive: true, force: true });
  return served;
}
