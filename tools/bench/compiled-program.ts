import type { ProjectFiles } from '../../app/contract/contract.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { Program } from '../../export/program/program.ts';

/** Compiles a project that must have no mistakes, without source maps, as exports do. */
export async function compiledProgram(folder: string, files: ProjectFiles, options: CompileOptions = {}): Promise<Program> {
  const { program, diagnostics } = await compileProject(folder, files, () => ({ sourceMaps: false, ...options }));
  if (program === null) throw new Error(`${folder} does not compile: ${JSON.stringify(diagnostics)}`);
  return program;
}
