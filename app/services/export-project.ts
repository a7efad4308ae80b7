import { readFile } from 'node:fs/promises';
import { bundlePage } from '../../export/bundle/bundle-page.ts';
import type { PosterPicture } from '../../export/bundle/poster.ts';
import type { ExportReport } from '../../export/bundle/report.ts';
import type { Program } from '../../export/program/program.ts';
import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { createAssetCache } from './asset-cache.ts';
import { compileProject } from './compile-project.ts';
import { resolveInside } from './confine.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import type { Installation } from './installation.ts';
import { writePageFolder } from './page-folder.ts';

export interface ExportJob {
  /** The project's real folder, where its assets are. */
  readonly root: string;
  readonly projectFiles: ProjectFiles;
  /** Folder for the page. */
  readonly out: string;
  readonly installation: Installation;
  readonly files?: FileLayer;
  /** False leaves models as they are; true unless given. */
  readonly compress?: boolean;
  /** Hears what takes its time. */
  readonly say?: (text: string) => void;
  /** Everything in one file, which opens from a disk. */
  readonly singleFile?: boolean;
  /** Where the page will be published, ending in `/`. */
  readonly address?: string | null;
  /** A picture of the page, by whoever can draw one; else a neutral one takes its place. */
  readonly drawPoster?: (program: Program) => Promise<PosterPicture | null>;
}

export interface ExportOutcome {
  /** Null where nothing was written. */
  readonly report: ExportReport | null;
  readonly diagnostics: readonly Diagnostic[];
}

/** Compiles, bundles, and puts the page into `out` in one step. Never rejects for what a user can mend. */
export async function exportProject(job: ExportJob): Promise<ExportOutcome> {
  const { root, projectFiles, out, installation, files = NODE_FILES, compress = true, say = () => {} } = job;
  const { singleFile = false, address = null, drawPoster } = job;
  const { project, program, diagnostics } = await compileProject(root, projectFiles, () => ({ sourceMaps: false }));
  if (project === null || program === null || hasErrors(diagnostics)) return { report: null, diagnostics };
  const all = [...diagnostics];
  try {
    const report = await writePageFolder(out, files, async (sink) => {
      const bundled = await bundlePage({
        program,
        page: project.page,
        generator: `Scrim ${installation.version}`,
        root: installation.root,
        readAsset: async (path) => readFile(await resolveInside(root, path)),
        sink,
        compress,
        // Not through `files`: what a cache cannot keep is no reason to stop.
        cache: createAssetCache(root, NODE_FILES),
        say,
        singleFile,
        address,
        poster: (await drawPoster?.(program)) ?? null,
      });
      all.push(...bundled.diagnostics);
      return bundled.output;
    });
    return { report, diagnostics: all };
  } catch (error) {
    if (error instanceof HostError) return { report: null, diagnostics: [...all, error.diagnostic as Diagnostic] };
    throw error;
  }
}
