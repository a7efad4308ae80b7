import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { Project } from '../../export/graph/project.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { type CompiledProject, compileProject } from '../services/compile-project.ts';
import { NODE_FILES } from '../services/file-layer.ts';
import { findProject } from '../services/project-files.ts';
import { readConsistentFiles } from '../services/recover-folder.ts';

export interface CompiledFolder extends CompiledProject {
  readonly root: string;
  readonly files: ProjectFiles;
}

/**
 * Reads and compiles the project at a path.
 *
 * @throws SCR004, SCR005
 */
export async function compileFolder(path: string, optionsOf?: (project: Project) => CompileOptions): Promise<CompiledFolder> {
  const root = await findProject(path);
  const files = await readConsistentFiles(root, NODE_FILES);
  return { root, files, ...(await compileProject(root, files, optionsOf)) };
}
