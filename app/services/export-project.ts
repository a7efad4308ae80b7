import type { HostOutput, ProjectFiles } from '../contract/contract.ts';
import type { Installation } from './installation.ts';

export interface ExportJob {
  /** The project's real folder, where its assets are. */
  readonly root: string;
  readonly files: ProjectFiles;
  readonly out: string;
  readonly installation: Installation;
}

export function exportProject(_job: ExportJob): Promise<HostOutput<'export.run'>> {
  throw new Error('exportProject is written when the compiler and bundler are there');
}
