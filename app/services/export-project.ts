import { bundlePage } from '../../export/bundle/bundle-page.ts';
import type { PosterImage } from '../../export/bundle/poster.ts';
import type { ExportReport } from '../../export/bundle/report.ts';
import { imageSize } from '../../export/gltf/image-size.ts';
import type { Project } from '../../export/graph/project.ts';
import type { Program } from '../../export/program/program.ts';
import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import type { PosterFraming } from '../../nodes/kit/poster-framing.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { createAssetCache } from './asset-cache-folder.ts';
import { compileProject } from './compile-project.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import type { Installation } from './installation.ts';
import { writePageFolder } from './page-folder.ts';
import { readAsset, readAssetFile } from './read-asset.ts';

export interface ExportJob {
  /** Real path of the project folder. */
  readonly root: string;
  readonly projectFiles: ProjectFiles;
  /** Folder of the page. */
  readonly out: string;
  readonly installation: Installation;
  readonly files?: FileLayer;
  /** Whether to compress models. Default: true. */
  readonly compress?: boolean;
  /** Cancels the export: removes its files and rejects with the reason of the signal. */
  readonly interrupted?: AbortSignal;
  /** Called with progress texts. */
  readonly say?: (text: string) => void;
  /** Whether to write a single HTML file that opens from a disk. */
  readonly singleFile?: boolean;
  /** Whether the page opens offline after a visit. Default: true. */
  readonly offline?: boolean;
  /** Address of the published page, ending in `/`. */
  readonly address?: string | null;
  /**
   * Renders the poster. If it returns null, the page gets a neutral poster and a warning (SCR065). If it throws SCR042, the export
   * ends, because no page can draw the shader.
   */
  readonly drawPoster?: (program: Program, framing: PosterFraming | null) => Promise<PosterImage | null>;
}

export interface ExportOutcome {
  /** Report of the export; null if nothing was written. */
  readonly report: ExportReport | null;
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Compiles and bundles a page, and writes it to `out` in one step. Mistakes of the user are diagnostics. Rejects only if interrupted.
 */
export async function exportProject(job: ExportJob): Promise<ExportOutcome> {
  const { root, projectFiles, out, installation, compress = true, interrupted } = job;
  const say = (text: string) => {
    // The next steps take long, so check for an interrupt.
    interrupted?.throwIfAborted();
    job.say?.(text);
  };
  const files = watchedFiles(job.files ?? NODE_FILES, interrupted, (count) => say(`Writing file ${count}…`));
  const { singleFile = false, offline = true, address = null, drawPoster } = job;
  say('Compiling…');
  const { project, program, diagnostics } = await compileProject(
    root,
    projectFiles,
    () => ({ sourceMaps: false, fuse: true, fold: true }),
    {
      root: installation.root,
      interrupted,
    },
  );
  if (project === null || program === null || hasErrors(diagnostics)) return { report: null, diagnostics };
  const all = [...diagnostics];
  try {
    const report = await writePageFolder(out, files, async (sink) => {
      const bundled = await bundlePage({
        program,
        page: project.page,
        generator: `Scrim ${installation.version}`,
        root: installation.root,
        readAsset: (path) => readAssetFile(root, path),
        sink,
        compress,
        // Bypasses `files`, because failures of the cache must not stop the export.
        cache: createAssetCache(root, NODE_FILES),
        say,
        singleFile,
        offline,
        address,
        drawPoster: async () => {
          const poster = await posterOf(project, program, job);
          if (poster === null && drawPoster) all.push(NO_POSTER);
          return poster;
        },
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

const NO_POSTER: Diagnostic = {
  code: 'SCR065',
  severity: 'warning',
  message: 'The poster of the page could not be rendered. Link previews show a neutral one.',
};

/** The poster that the project has chosen, if its file can be used; else a drawn one. */
async function posterOf({ page }: Project, program: Program, { root, drawPoster, interrupted }: ExportJob): Promise<PosterImage | null> {
  const chosen = page.poster === undefined ? null : await readAsset(root, page.poster).catch(() => null);
  const size = chosen && imageSize(chosen);
  const type = chosen?.[0] === 0xff ? 'jpg' : 'png';
  if (chosen && size && size.ktx2 === null) return { type, bytes: chosen, drawn: true, widthPx: size.widthPx, heightPx: size.heightPx };
  try {
    return (await drawPoster?.(program, page.framing ?? null)) ?? null;
  } catch (error) {
    interrupted?.throwIfAborted();
    if (error instanceof HostError && error.diagnostic.code === 'SCR042') throw error;
    return null;
  }
}

/**
 * Wraps a file layer: counts written files, and throws when interrupted, so that an unfinished folder is removed as after a full disk.
 * Renames are not interrupted, because a folder is replaced by two renames, and both must happen.
 */
function watchedFiles(files: FileLayer, interrupted: AbortSignal | undefined, onWrite: (count: number) => void): FileLayer {
  let count = 0;
  return {
    ...files,
    writeNew: async (path, bytes) => {
      interrupted?.throwIfAborted();
      onWrite(++count);
      await files.writeNew(path, bytes);
    },
    makeFolder: async (path) => {
      interrupted?.throwIfAborted();
      await files.makeFolder(path);
    },
  };
}
