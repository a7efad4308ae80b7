import { compileApart } from '../../export/bundle/compile/compile-apart.ts';
import { type CompileOptions, compile } from '../../export/compiler/compile.ts';
import { isImported } from '../../export/compiler/imported-assets.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import type { Program } from '../../export/program/program.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { libraryOf, type NodeLibrary } from '../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { checkAssets } from './check-assets.ts';
import { checkModels } from './check-models.ts';

export interface CompiledProject {
  /** Null where the files could not be read as a project. */
  readonly project: Project | null;
  /** Null where something is wrong that no page can be made of. */
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
}

/** Where large projects are compiled beside the program that asks, which goes on meanwhile. */
export interface Apart {
  /** Absolute folder with Scrim's sources. */
  readonly root: string;
  readonly interrupted?: AbortSignal | undefined;
}

/** Fewer nodes than this compile in less time than a thread takes to start. */
const LARGE = 1000;

/** By what is written down; subgraphs may make any number of nodes of it. */
function isLarge({ graphs }: Project): boolean {
  const count = Object.values(graphs).reduce((sum, { nodes }) => sum + Object.keys(nodes).length, 0);
  return count > LARGE || Object.keys(graphs).length > 1;
}

/** A project's files as a program, or what is wrong with them: documents, graph, shaders, and the asset files in `root`. */
export async function compileProject(
  root: string,
  files: ProjectFiles,
  optionsOf: (project: Project) => CompileOptions = () => ({}),
  apart: Apart | null = null,
): Promise<CompiledProject> {
  const loaded = loadProject(files);
  const project = loaded.output;
  if (project === null) return { project, program: null, diagnostics: loaded.diagnostics };
  const options = optionsOf(project);
  const compiled =
    apart !== null && isLarge(project)
      ? await compileApart(apart.root, { project, definitions: DEFINITIONS, shaders: SHADERS, options }, apart.interrupted)
      : compile({ project, library: LIBRARY, options });
  const played = compiled.output?.assets ?? [];
  const used = new Set(compiled.output ? played.map(({ id }) => id) : Object.keys(project.assets));
  // Pictures that shaders import stand in no table of the project's.
  const all = { ...project.assets, ...Object.fromEntries(played.filter(isImported).map((asset) => [asset.id, asset])) };
  // A path that the compiler refused already is not told of twice.
  const assets = (await checkAssets(root, all, used)).filter(({ code }) => code !== 'SCR031' || !hasErrors(compiled.diagnostics));
  const known = new Set(assets.flatMap(({ file }) => file ?? []));
  const models = compiled.output === null ? [] : await checkModels(root, compiled.output, known);
  const diagnostics = [...loaded.diagnostics, ...compiled.diagnostics, ...assets, ...models];
  return { project, program: hasErrors(diagnostics) ? null : compiled.output, diagnostics };
}

/** The node types of this Scrim; a project's own shaders are put before them by the compiler. */
export const LIBRARY: NodeLibrary = libraryOf(DEFINITIONS, SHADERS);
