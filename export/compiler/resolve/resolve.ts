import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { type Diagnostic, hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { migrateNodes } from '../../graph/library/migrate-nodes.ts';
import { createInterfaceLookup } from '../../graph/library/node-interface.ts';
import type { ProjectLogic } from '../../graph/project.ts';
import { checkGraphs } from '../../graph/validate/check-project.ts';
import type { FlatGraph } from '../flat-graph.ts';
import { bypassMuted } from './bypass.ts';
import { flatten } from './flatten.ts';
import { listInstances, MAX_FLAT_NODES } from './instances.ts';

export interface Resolved {
  /** The project after migration of its params. */
  readonly project: ProjectLogic;
  readonly library: NodeLibrary;
  readonly graph: FlatGraph;
}

/** First phase: looks up node types, migrates params, inlines subgraphs and bypasses muted nodes. */
export function resolve(project: ProjectLogic, library: NodeLibrary): Result<Resolved> {
  const migrated = migrateNodes(project, library);
  const recursive = checkGraphs(migrated.project);
  if (hasErrors(recursive)) return { output: null, diagnostics: recursive };
  const instances = listInstances(migrated.project);
  if (!instances.ok) return { output: null, diagnostics: [tooMany(migrated.project)] };
  const draft = flatten(instances.list, createInterfaceLookup(migrated.project, library), library);
  const { nodes, replacements } = bypassMuted(draft);
  const screens = [...nodes.values()].filter((node) => node.definition.lowering.kind === 'present');
  const [screen = null] = screens.length === 1 ? screens : [];
  const graph: FlatGraph = { nodes, aliases: draft.aliases, replacements, screen };
  return { output: { project: migrated.project, library, graph }, diagnostics: migrated.diagnostics };
}

function tooMany({ graphs }: ProjectLogic): Diagnostic {
  const count = MAX_FLAT_NODES.toLocaleString('en-US');
  const nested = Object.keys(graphs).length > 1;
  return {
    code: 'SCR026',
    severity: 'error',
    message: nested
      ? `The project has more than ${count} nodes, counting subgraphs once per use. Scrim compiles at most ${count}.`
      : `The project has more than ${count} nodes. Scrim compiles at most ${count}.`,
    fix: nested ? 'Nest fewer subgraphs, or mute some of them.' : 'Delete nodes, or split the project.',
  };
}
