import type { Binding, Graph, GraphNode, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeDefinition, NodeLibrary, ParamValue } from '../../../nodes/kit/definition.ts';

/** A new value of a param in the running program. */
export interface ParamEdit {
  readonly graph: string;
  readonly node: string;
  readonly param: string;
  readonly value: ParamValue;
}

/** What a change of the project requires: nothing, new param values, or a recompile. */
export type Consequence =
  | { readonly kind: 'nothing' }
  | { readonly kind: 'params'; readonly edits: readonly ParamEdit[] }
  | { readonly kind: 'program' };

/** Compares two states of a project. Identical objects count as unchanged, so the cost depends on the size of the change. */
export function consequenceOf(before: Project, after: Project, library: NodeLibrary): Consequence {
  if (before.sources !== after.sources || before.assets !== after.assets || before.title !== after.title || before.page !== after.page) {
    return { kind: 'program' };
  }
  if (before.graphs === after.graphs) return { kind: 'nothing' };
  if (!sameKeys(before.graphs, after.graphs)) return { kind: 'program' };
  const edits: ParamEdit[] = [];
  for (const [name, graph] of Object.entries(after.graphs)) {
    const old = getOwn(before.graphs, name);
    if (old === graph) continue;
    if (!old || !collectEdits(name, old, graph, library, edits)) return { kind: 'program' };
  }
  return edits.length === 0 ? { kind: 'nothing' } : { kind: 'params', edits };
}

/** Collects changed param values. Returns false if anything else changed. */
function collectEdits(name: string, before: Graph, after: Graph, library: NodeLibrary, edits: ParamEdit[]): boolean {
  if (before.wires !== after.wires || before.exposed !== after.exposed || !sameKeys(before.nodes, after.nodes)) return false;
  for (const [id, node] of Object.entries(after.nodes)) {
    const old = getOwn(before.nodes, id);
    if (old === node) continue;
    if (!old || old.type !== node.type || old.version !== node.version || old.muted !== node.muted) return false;
    if (!collectParams(name, id, old, node, library, edits)) return false;
  }
  return true;
}

function collectParams(graph: string, id: string, before: GraphNode, after: GraphNode, library: NodeLibrary, edits: ParamEdit[]): boolean {
  const definition = library.definition(after.type);
  if (!definition) return false;
  for (const param of new Set([...Object.keys(before.params), ...Object.keys(after.params)])) {
    const old = getOwn(before.params, param);
    const next = getOwn(after.params, param);
    if (old === next) continue;
    const declared = getOwn(definition.params, param);
    if (declared?.stage !== 'uniform' || choosesGlyphs(definition, param)) return false;
    const value = heldValue(next, declared.default);
    if (value === undefined || heldValue(old, declared.default) === undefined) return false;
    edits.push({ graph, node: id, param, value });
  }
  return true;
}

/** Whether the value of a param decides which glyphs the program contains. */
function choosesGlyphs({ params }: NodeDefinition, param: string): boolean {
  return Object.values(params).some((other) => other.type === 'text' && other.glyphs?.of === param);
}

/**
 * The constant value of a binding; undefined for a track or an expression. A connected port also has a value, which has no visible
 * effect.
 */
function heldValue(binding: Binding | undefined, byDefault: ParamValue): ParamValue | undefined {
  if (binding === undefined) return byDefault;
  if ('value' in binding) return binding.value;
  return 'port' in binding ? binding.port : undefined;
}

function sameKeys(a: object, b: object): boolean {
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key) => Object.hasOwn(b, key));
}
