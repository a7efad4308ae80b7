import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { compile } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { LIBRARY } from './library.ts';

/**
 * Compiles a project.
 *
 * @throws If there is any diagnostic.
 */
export function compileText(project: string, options: CompileOptions = {}): Program {
  const loaded = loadProject({ project, layout: null, sources: {} });
  const compiled = loaded.output ? compile({ project: loaded.output, library: LIBRARY, options }) : null;
  if (!compiled?.output) throw new Error(JSON.stringify([loaded.diagnostics, compiled?.diagnostics]));
  return compiled.output;
}

export async function compileExample(folder: string): Promise<Program> {
  return compileText(await readFile(join(folder, 'project.scrim.json'), 'utf8'));
}
