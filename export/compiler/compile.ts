import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../nodes/kit/diagnostics.ts';
import type { Before } from '../glsl/link/link-above.ts';
import { isProjectShader, type ProjectLibrary, projectLibrary } from '../graph/library/project-library.ts';
import type { ProjectLogic } from '../graph/project.ts';
import { deviceTable, deviceWarnings } from '../program/devices/device-table.ts';
import type { LinkedShader, Program } from '../program/program.ts';
import { type Checked, check } from './check/check-resolved.ts';
import type { CompileOptions } from './compile-options.ts';
import type { FlatGraph } from './flat-graph.ts';
import { fold } from './fold/fold.ts';
import type { FoldedNode } from './fold/folded-node.ts';
import type { UnchangedLayers } from './fold/unchanged.ts';
import { link, named } from './link/link.ts';
import { print } from './print/print-program.ts';
import { logReads } from './relink/read-log.ts';
import { type Compilation, type CompilationInput, relink } from './relink/relink.ts';
import { resolve } from './resolve/resolve.ts';
import type { SeparateWire } from './schedule/fuse/separate-wire.ts';
import { describeLayers } from './schedule/layers.ts';
import { type ScheduleResult, schedule } from './schedule/schedule.ts';
import { createShaderStore, type ShaderStore } from './shaders/shader-store.ts';

export interface CompileInput {
  readonly project: ProjectLogic;
  /** Node types and shader texts; the project's own shaders need not be in it. */
  readonly library: NodeLibrary;
  readonly options?: CompileOptions;
}

export interface Compiler {
  compile(input: CompileInput): Compiled;
}

/** A program, or null with at least one error. */
export interface Compiled extends Result<Program> {
  /** If shaders cannot be read: their texts above the mistakes, so that a driver can check these. Empty if there is a program. */
  readonly above: readonly ShaderAbove[];
  /** Layers that passes read as textures, and why they are not fused. */
  readonly separate: readonly SeparateWire[];
  /** Nodes that folding leaves out, and why; absent without folding. */
  readonly folded?: readonly FoldedNode[];
}

/** The text above a mistake, completed to a valid shader. It is only compiled, to find mistakes further above, and never drawn. */
export interface ShaderAbove {
  readonly shader: LinkedShader;
  readonly before: Before;
}

/**
 * Creates a compiler, which caches shaders by their text across projects and compilations. After an edit of shaders alone, it links only
 * these again (`relink`), unless passes are fused.
 *
 * Every uniform param that can be set at run time is in `program.slots.params`. A missing param either has no effect on the render or is
 * compiled in (such as the opacity of an `over` that blending replaces): compile again to change it.
 *
 * @example
 * const compiler = createCompiler();
 * const { output, diagnostics } = compiler.compile({ project, library, options: { loopBudget: true } });
 */
export function createCompiler(): Compiler {
  const shaders = createShaderStore();
  let last: Compilation | null = null;
  return {
    compile: ({ project, library: base, options = {} }) => {
      const input = { project, options, library: projectLibrary(base, project.sources, shaders.readDefinition) };
      if (options.fuse || options.fold) return compileWhole(input, shaders).compiled;
      const relinked = last && relink(last, input, shaders);
      if (relinked === null) {
        const { compiled, compilation } = compileWhole(input, shaders);
        last = compilation ?? last;
        return compiled;
      }
      last = relinked;
      return finish(relinked);
    },
  };
}

/** Runs all phases. There is a compilation if there is a program. */
function compileWhole(
  input: CompilationInput,
  store: ShaderStore,
): { readonly compiled: Compiled; readonly compilation: Compilation | null } {
  const { project, options } = input;
  const {
    taps = [],
    thumbnails = [],
    loopBudget = false,
    fuse = false,
    fold: folds = false,
    opaqueImages = [],
    opaqueModels = [],
    reportUnused,
  } = options;
  const { library, shaders, log } = logReads(input.library, store);
  const diagnostics: Diagnostic[] = [];
  const failed = (above: readonly ShaderAbove[] = []) => ({
    compiled: { output: null, diagnostics, above, separate: [] },
    compilation: null,
  });

  const resolved = resolve(project, library);
  diagnostics.push(...resolved.diagnostics);
  if (resolved.output === null) return failed();
  const migrated = resolved.output.project;
  const checked = check(resolved.output, { taps, thumbnails });
  diagnostics.push(...headerDiagnostics(input.library, migrated), ...checked.diagnostics);
  if (checked.output === null || hasErrors(diagnostics)) return failed();
  const folding = folds ? fold(checked.output, unchangedLayers(checked.output, library, shaders)) : null;
  const used = folding?.checked ?? checked.output;
  const known = { opaqueImages: new Set(opaqueImages), opaqueModels: new Set(opaqueModels) };
  const scheduled = schedule(used, { library, shaders, loopBudget, fuse, ...known });
  diagnostics.push(...scheduled.diagnostics);
  if (scheduled.output === null) return failed(shadersAbove(scheduled));
  if (reportUnused) diagnostics.push(...unusedNodes(resolved.output.graph, checked.output.live));
  const compilation = { ...input, log, migrated, schedule: scheduled.output, diagnostics };
  return { compiled: { ...finish(compilation), ...(folding && { folded: folding.folded }) }, compilation };
}

/** Links and prints the program. */
function finish({ migrated, schedule: scheduled, diagnostics, options: { sourceMaps = true } }: Compilation): Compiled {
  const program = print(migrated, scheduled, link(scheduled, { sourceMaps }));
  return {
    output: program,
    diagnostics: [...diagnostics, ...deviceWarnings(deviceTable(program))],
    above: [],
    separate: scheduled.separate,
  };
}

/**
 * Compiles one project. Use `createCompiler` to compile repeatedly.
 *
 * @param input The project, the library of node types and options.
 * @returns The program, or null with at least one error. Never throws on mistakes in the project.
 *
 * @example
 * const { output: program, diagnostics } = compile({ project, library });
 */
export function compile(input: CompileInput): Compiled {
  return createCompiler().compile(input);
}

function unchangedLayers({ graph, live }: Checked, library: NodeLibrary, shaders: ShaderStore): UnchangedLayers {
  const shaderOf: UnchangedLayers['shaderOf'] = ({ definition: { lowering } }) => {
    const source = lowering.kind === 'image' ? library.shader(lowering.shader) : undefined;
    return source === undefined || lowering.kind !== 'image' ? null : shaders.read(lowering.shader, source).output;
  };
  return {
    layers: describeLayers(live),
    node: (id) => graph.nodes.get(id),
    shaderOf,
    isOfProject: ({ definition: { lowering } }) => lowering.kind === 'image' && isProjectShader(lowering.shader),
  };
}

/** The shaders above mistakes, without duplicates, because nodes of one file share them. */
function shadersAbove({ above }: ScheduleResult): ShaderAbove[] {
  const made = above.flatMap(({ shaders, before, node }) =>
    shaders.map((shader): [string, ShaderAbove] => [shader.id, { shader: named(shader, node), before }]),
  );
  return [...new Map(made).values()];
}

/** Problems in shader headers: errors if a node uses the shader, otherwise warnings. */
function headerDiagnostics({ diagnostics }: ProjectLibrary, { graphs }: ProjectLogic): Diagnostic[] {
  const used = new Set(
    Object.values(graphs).flatMap(({ nodes }) => Object.values(nodes).map(({ type }) => type.slice(type.indexOf('/') + 1))),
  );
  return diagnostics.map((diagnostic) => {
    const name = diagnostic.file?.replace(/^shaders\//, '').replace(/\.(fs|glsl)$/, '');
    return name === undefined || used.has(name) ? diagnostic : { ...diagnostic, severity: 'warning' };
  });
}

function unusedNodes({ nodes }: FlatGraph, live: readonly { readonly id: string }[]): Diagnostic[] {
  const used = new Set(live.map(({ id }) => id));
  return [...nodes.keys()].sort().flatMap((nodeId): Diagnostic[] => {
    if (used.has(nodeId)) return [];
    return [
      { code: 'SCR021', severity: 'info', nodeId, message: `The output does not depend on ${nodeId}.`, fix: 'Connect it, or delete it.' },
    ];
  });
}
