import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../nodes/kit/diagnostics.ts';
import type { Before } from '../glsl/link/link-above.ts';
import { isProjectShader, type ProjectLibrary, projectLibrary } from '../graph/library/project-library.ts';
import type { ProjectLogic } from '../graph/project.ts';
import { deviceTable, deviceWarnings } from '../program/devices/device-table.ts';
import type { LinkedShader, Program } from '../program/program.ts';
import { type Checked, check } from './check/check-resolved.ts';
import type { FlatGraph } from './flat-graph.ts';
import { fold } from './fold/fold.ts';
import type { FoldedNode } from './fold/folded-node.ts';
import type { UnchangedLayers } from './fold/unchanged.ts';
import { link, named } from './link/link.ts';
import { print } from './print/print-program.ts';
import { resolve } from './resolve/resolve.ts';
import type { SeparateWire } from './schedule/fuse/separate-wire.ts';
import { describeLayers } from './schedule/layers.ts';
import { type ScheduleResult, schedule } from './schedule/schedule.ts';
import { createShaderStore, type ShaderStore } from './shaders/shader-store.ts';

export interface CompileOptions {
  /** Layers to view, as `node.port`; missing ones are left out of `program.taps`. */
  readonly taps?: readonly string[];
  /**
   * Further layers to view, in small. One that would make the program request a capability, read input, show controls or depend on earlier frames is left out, so
   * that thumbnails do not change how the program plays.
   */
  readonly thumbnails?: readonly string[];
  /** Bound the loops of shaders (docs/adr/0012): for previews, never for exports. */
  readonly loopBudget?: boolean;
  /** Keep the source maps of shaders; true by default. */
  readonly sourceMaps?: boolean;
  /** Draw several passes by one shader where the image stays the same (docs/adr/0043): for exports and plans. */
  readonly fuse?: boolean;
  /** Ids of image assets without transparency, whose fused passes need not divide by alpha. */
  readonly opaqueImages?: readonly string[];
  /** Ids of model assets without transparent materials, in which effects can be computed (docs/adr/0055). */
  readonly opaqueModels?: readonly string[];
  /** Compute once what is the same in every frame while only controls of the page set params (docs/adr/0048): for exports and plans. */
  readonly fold?: boolean;
  /** Report nodes that the output does not depend on (SCR021). */
  readonly reportUnused?: boolean;
}

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
 * Creates a compiler, which caches shaders by their text across projects and compilations.
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
  return {
    compile: ({ project, library: base, options = {} }) => {
      const { taps = [], thumbnails = [], loopBudget = false, sourceMaps = true, reportUnused = false } = options;
      const { fuse = false, fold: folds = false, opaqueImages = [], opaqueModels = [] } = options;
      const diagnostics: Diagnostic[] = [];
      const library = projectLibrary(base, project.sources, shaders.readDefinition);

      const resolved = resolve(project, library);
      diagnostics.push(...resolved.diagnostics);
      if (resolved.output === null) return { output: null, diagnostics, above: [], separate: [] };
      const checked = check(resolved.output, { taps, thumbnails });
      diagnostics.push(...headerDiagnostics(library, resolved.output.project), ...checked.diagnostics);
      if (checked.output === null || hasErrors(diagnostics)) return { output: null, diagnostics, above: [], separate: [] };
      const folding = folds ? fold(checked.output, unchangedLayers(checked.output, library, shaders)) : null;
      const used = folding?.checked ?? checked.output;
      const known = { opaqueImages: new Set(opaqueImages), opaqueModels: new Set(opaqueModels) };
      const scheduled = schedule(used, { library, shaders, loopBudget, fuse, ...known });
      diagnostics.push(...scheduled.diagnostics);
      if (scheduled.output === null) return { output: null, diagnostics, above: shadersAbove(scheduled), separate: [] };
      const linked = link(scheduled.output, { sourceMaps });
      if (reportUnused) diagnostics.push(...unusedNodes(resolved.output.graph, checked.output.live));
      const program = print(resolved.output.project, scheduled.output, linked);
      diagnostics.push(...deviceWarnings(deviceTable(program)));
      return {
        output: program,
        diagnostics,
        above: [],
        separate: scheduled.output.separate,
        ...(folding && { folded: folding.folded }),
      };
    },
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

function unchangedLayers({ graph, live }: Checked, library: ProjectLibrary, shaders: ShaderStore): UnchangedLayers {
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
