import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { createFaceLookup } from '../../graph/library/faces.ts';
import { migrateNodes } from '../../graph/library/migrate-nodes.ts';
import type { ProjectLogic } from '../../graph/project.ts';
import { checkGraphs } from '../../graph/validate/check-project.ts';
import type { FlatGraph } from '../flat-graph.ts';
import { bypassMuted } from './bypass.ts';
import { flatten } from './flatten.ts';
import { listInstances, MAX_FLAT_NODES } from './instances.ts';

export interface Resolved {
  /** With the params of every node in the version that the library has. */
  readonly project: ProjectLogic;
  readonly library: NodeLibrary;
  readonly graph: FlatGraph;
}

/** First phase: ids to definitions, old params to new ones, subgraphs inlined, muted nodes bypassed. */
export function resolve(project: ProjectLogic, library: NodeLibrary): Result<Resolved> {
  const migrated = migrateNodes(project, library);
  const recursive = checkGraphs(migrated.project);
  if (hasErrors(recursive)) return { output: null, diagnostics: recursive };
  const instances = listInstances(migrated.project);
  if (!instances.ok) return { output: null, diagnostics: [tooMany()] };
  const draft = flatten(instances.list, createFaceLookup(migrated.project, library), library);
  const { nodes, standIns } = bypassMuted(draft);
  const screens = [...nodes.values()].filter((node) => node.definition.lowering.kind === 'present');
  const [screen = null] = screens.length === 1 ? screens : [];
  const graph: FlatGraph = { nodes, aliases: draft.aliases, standIns, screen };
  return { output: { project: migrated.project, library, graph }, diagnostics: migrated.diagnostics };
}

function tooMany(): Diagnostic {
  const message = `The subgraphs make more than ${MAX_FLAT_NODES} nodes when they are put in each other's place.`;
  return { code: 'SCR020', severity: 'error', message, fix: 'Use subgraphs fewer times within each other.' };
}
