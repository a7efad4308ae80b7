import { createCompiler } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import { putAsset } from '../../export/graph/commands/asset-commands.ts';
import type { Change } from '../../export/graph/commands/change.ts';
import { moveNodes } from '../../export/graph/commands/layout-commands.ts';
import { addNode, removeNodes, setMuted } from '../../export/graph/commands/node-commands.ts';
import { bindParam, setParam } from '../../export/graph/commands/param-commands.ts';
import { setSource } from '../../export/graph/commands/shader-commands.ts';
import { addGraph, exposePort } from '../../export/graph/commands/subgraph-commands.ts';
import { connect, disconnect } from '../../export/graph/commands/wire-commands.ts';
import { emptyHistory, type History, record, redo, undo } from '../../export/graph/history.ts';
import { type ProjectLibrary, projectLibrary, type ReadShader } from '../../export/graph/library/project-library.ts';
import { loadProject, type ProjectTexts } from '../../export/graph/load.ts';
import { newProject } from '../../export/graph/new-project.ts';
import { type Asset, type Binding, MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { parseWire } from '../../export/graph/wires.ts';
import type { Program } from '../../export/program/program.ts';
import type { NodeLibrary, ParamValue } from '../../nodes/kit/definition.ts';
import { type Diagnostic, formatDiagnostic, hasErrors, type Result } from '../../nodes/kit/diagnostics.ts';

export interface StudioOptions {
  /** The library without the shaders of the project. */
  readonly library: NodeLibrary;
  readonly readShader: ReadShader;
  readonly project?: Project;
}

/**
 * The editor without its windows: a project with its history and a compiler, driven by one command after the other. Commands that are refused
 * throw, because a test that goes on with another project than it thinks proves nothing; `attempt` is for those that should be.
 *
 * @example
 * const studio = new TestStudio({ library, readShader })
 *   .add('video-aaaa', 'source/camera-video')
 *   .add('screen-aaaa', 'output/screen')
 *   .wire('video-aaaa.layer -> screen-aaaa.layer');
 */
export class TestStudio {
  project: Project;
  history: History = emptyHistory();
  private graph = MAIN_GRAPH;
  private readonly options: StudioOptions;
  private readonly compiler = createCompiler();

  constructor(options: StudioOptions) {
    this.options = options;
    this.project = options.project ?? newProject('Test');
  }

  /** The library with the shaders of the project. */
  get library(): ProjectLibrary {
    return projectLibrary(this.options.library, this.project.sources, this.options.readShader);
  }

  /** Runs a command. Commands with the same `key` form one undo step. */
  run(command: (project: Project) => Change, key?: string): this {
    const refused = this.attempt(command, key).find(({ severity }) => severity === 'error');
    if (refused) throw new Error(formatDiagnostic(refused));
    return this;
  }

  /** Runs a command that may be rejected, and returns its diagnostics. */
  attempt(command: (project: Project) => Change, key?: string): readonly Diagnostic[] {
    const change = command(this.project);
    if (!hasErrors(change.diagnostics)) {
      this.history = record(this.history, change, { label: 'test', ...(key === undefined ? {} : { key }) });
      this.project = change.project;
    }
    return change.diagnostics;
  }

  /** Selects the graph of the following commands. Creates it if it is missing. */
  in(graph: string): this {
    if (!Object.hasOwn(this.project.graphs, graph)) this.run((project) => addGraph(project, { name: graph }));
    this.graph = graph;
    return this;
  }

  add(id: string, type: string, params: Readonly<Record<string, ParamValue>> = {}): this {
    const { library, graph } = this;
    return this.run((project) => addNode(project, { library, graph, id, type, x: 0, y: 0, params }));
  }

  remove(...nodes: string[]): this {
    const { library, graph } = this;
    return this.run((project) => removeNodes(project, { library, graph, nodes }));
  }

  wire(...texts: string[]): this {
    const { library, graph } = this;
    for (const text of texts) this.run((project) => connect(project, { library, graph, ...wireOf(text) }));
    return this;
  }

  unwire(...texts: string[]): this {
    const { graph } = this;
    return this.run((project) => disconnect(project, { graph, wires: texts.map(wireOf) }));
  }

  set(address: string, value: ParamValue, key?: string): this {
    const { library, graph } = this;
    const [node = '', param = ''] = address.split('.');
    return this.run((project) => setParam(project, { library, graph, node, param, value }), key);
  }

  bind(address: string, binding: Binding): this {
    const { library, graph } = this;
    const [node = '', param = ''] = address.split('.');
    return this.run((project) => bindParam(project, { library, graph, node, param, binding }));
  }

  mute(...nodes: string[]): this {
    const { graph } = this;
    return this.run((project) => setMuted(project, { graph, nodes, muted: true }));
  }

  move(id: string, x: number, y: number, key?: string): this {
    const { graph } = this;
    return this.run((project) => moveNodes(project, { graph, positions: { [id]: { x, y } } }), key);
  }

  expose(side: 'inputs' | 'outputs', name: string, address: string): this {
    const { library, graph } = this;
    const [node = '', port = ''] = address.split('.');
    return this.run((project) => exposePort(project, { library, graph, side, name, node, port }));
  }

  asset(id: string, asset: Asset): this {
    return this.run((project) => putAsset(project, { id, asset }));
  }

  source(file: string, text: string): this {
    const { library: base, readShader } = this.options;
    return this.run((project) => setSource(project, { base, readShader, file, text }));
  }

  undo(): this {
    return this.travel(undo(this.history, this.project), 'undo');
  }

  redo(): this {
    return this.travel(redo(this.history, this.project), 'redo');
  }

  save(): ProjectTexts {
    return saveProject(this.project);
  }

  /** Closes and reopens the project, without its history. */
  reopen(): this {
    const { output, diagnostics } = loadProject(this.save());
    if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
    this.project = output;
    this.history = emptyHistory();
    return this;
  }

  diagnostics(): Diagnostic[] {
    return validateProject(this.project, this.library);
  }

  compile(options: CompileOptions = {}): Result<Program> {
    return this.compiler.compile({ project: this.project, library: this.options.library, options });
  }

  private travel(moved: ReturnType<typeof undo>, what: string): this {
    if (!moved) throw new Error(`There is nothing to ${what}.`);
    this.history = moved.history;
    this.project = moved.project;
    return this;
  }
}

export function wireOf(text: string) {
  const wire = parseWire(text);
  if (!wire) throw new Error(`"${text}" is no wire.`);
  return wire;
}
