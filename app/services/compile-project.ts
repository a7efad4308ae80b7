import { compileApart } from '../../export/bundle/compile/compile-apart.ts';
import { type Compiled, compile } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { FoldedNode } from '../../export/compiler/fold/folded-node.ts';
import { isImported } from '../../export/compiler/imported-assets.ts';
import type { SeparateWire } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { migrateNodes } from '../../export/graph/library/migrate-nodes.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import type { Program } from '../../export/program/program.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { libraryOf, type NodeLibrary } from '../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { checkAssets } from './check-assets.ts';
import { checkModels } from './check-models.ts';
import { findOpaqueImages } from './opaque-images.ts';
import { findOpaqueModels } from './opaque-models.ts';

export interface CompiledProject {
  /** The loaded project; null if the files could not be read as a project. */
  readonly project: Project | null;
  /** The compiled program; null after an error. */
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
  /** Layers that passes read as textures, and why they are not fused; empty if fusion is off. */
  readonly separate: readonly SeparateWire[];
  /** Nodes that folding leaves out; see `Compiled`. */
  readonly folded: readonly FoldedNode[];
}

/** Options to compile large projects in a worker. */
export interface Apart {
  /** Absolute path of the folder with Scrim’s sources. */
  readonly root: string;
  readonly interrupted?: AbortSignal | undefined;
}

/** Number of nodes above which a project is compiled in a worker. Smaller ones compile in less time than a worker takes to start. */
const LARGE = 1000;

/** Whether a project may be large: it has many stored nodes, or subgraphs, which may multiply them. */
function isLarge({ graphs }: Project): boolean {
  const count = Object.values(graphs).reduce((sum, { nodes }) => sum + Object.keys(nodes).length, 0);
  return count > LARGE || Object.keys(graphs).length > 1;
}

/** Compiles the files of a project. Checks documents, graph, shaders, and the asset files in `root`. */
export async function compileProject(
  root: string,
  files: ProjectFiles,
  optionsOf: (project: Project) => CompileOptions = () => ({}),
  apart: Apart | null = null,
): Promise<CompiledProject> {
  const loaded = loadProject(files);
  const project = loaded.output;
  if (project === null) return { project, program: null, diagnostics: loaded.diagnostics, separate: [], folded: [] };
  const asked = optionsOf(project);
  const options = asked.fuse ? { ...asked, ...(await findOpaque(root, project)) } : asked;
  const compiled =
    apart !== null && isLarge(project) ? await compileMigrated(project, options, apart) : compile({ project, library: LIBRARY, options });
  const played = compiled.output?.assets ?? [];
  const used = new Set(compiled.output ? played.map(({ id }) => id) : Object.keys(project.assets));
  // Images that shaders import are not in the asset table of the project.
  const all = { ...project.assets, ...Object.fromEntries(played.filter(isImported).map((asset) => [asset.id, asset])) };
  // Skips paths that the compiler has reported already.
  const assets = (await checkAssets(root, all, used)).filter(({ code }) => code !== 'SCR031' || !hasErrors(compiled.diagnostics));
  const known = new Set(assets.flatMap(({ file }) => file ?? []));
  const models = compiled.output === null ? [] : await checkModels(root, compiled.output, known);
  const diagnostics = [...loaded.diagnostics, ...compiled.diagnostics, ...assets, ...models];
  return {
    project,
    program: hasErrors(diagnostics) ? null : compiled.output,
    diagnostics,
    separate: compiled.separate,
    folded: compiled.folded ?? [],
  };
}

async function findOpaque(root: string, { assets }: Project): Promise<Pick<CompileOptions, 'opaqueImages' | 'opaqueModels'>> {
  const [opaqueImages, opaqueModels] = await Promise.all([findOpaqueImages(root, assets), findOpaqueModels(root, assets)]);
  return { opaqueImages, opaqueModels };
}

/** Migrates the params and then compiles in a worker, which cannot migrate params. */
async function compileMigrated(loaded: Project, options: CompileOptions, { root, interrupted }: Apart): Promise<Compiled> {
  const { project, diagnostics } = migrateNodes(loaded, LIBRARY);
  if (hasErrors(diagnostics)) return { output: null, diagnostics, above: [], separate: [] };
  const compiled = await compileApart(root, { project, definitions: DEFINITIONS, shaders: SHADERS, options }, interrupted);
  return { ...compiled, diagnostics: [...diagnostics, ...compiled.diagnostics] };
}

/** The node types of Scrim. The compiler adds the shaders of the project. */
export const LIBRARY: NodeLibrary = libraryOf(DEFINITIONS, SHADERS);
