import { castDraft } from 'immer';
import { EMPTY_GRAPH } from '../new-project.ts';
import type { GraphLayout, Project, Reroute } from '../project.ts';
import { getOwn } from '../record.ts';
import { pruneRoutes } from '../routes.ts';
import { type Change, change } from './change.ts';
import { checkLayoutId, rounded } from './layout-commands.ts';
import { draftLayout } from './node-commands.ts';

export interface PutReroute {
  readonly graph: string;
  /** From `makeLayoutId`, or the id of an existing reroute. */
  readonly id: string;
  readonly reroute: Reroute;
}

/**
 * Adds or moves a reroute. `pruneRoutesAfter` removes it if no route uses it.
 *
 * @throws Error if `id` is not a layout id.
 *
 * @example
 * putReroute(project, { graph: 'main', id: makeLayoutId(project, 'main', 'reroute', random), reroute: { x: 300, y: 120 } });
 */
export function putReroute(project: Project, { graph, id, reroute }: PutReroute): Change {
  checkLayoutId(id);
  return change(project, (draft) => {
    draftLayout(draft, graph).reroutes[id] = rounded(reroute);
  });
}

export interface SetRoutes {
  readonly graph: string;
  /** Wire, as `printWire` writes it → its reroutes from source to target. */
  readonly routes: Readonly<Record<string, readonly string[]>>;
}

/**
 * Sets the routes of wires. An empty list makes a wire direct.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setRoutes(project, { graph: 'main', routes: { [printWire(wire)]: ['reroute-p3m9'] } });
 */
export function setRoutes(project: Project, { graph, routes }: SetRoutes): Change {
  return change(project, (draft) => {
    const layout = draftLayout(draft, graph);
    for (const [wire, route] of Object.entries(routes)) {
      if (route.length === 0) delete layout.routes[wire];
      else layout.routes[wire] = [...route];
    }
  });
}

/**
 * Extends a change by `pruneRoutes` for each graph whose wires or layout it changed.
 *
 * @param before The project before the change.
 * @param made The change of a command.
 *
 * @example
 * const { project: pruned } = pruneRoutesAfter(project, disconnect(project, { graph: 'main', wires: [wire] }));
 */
export function pruneRoutesAfter(before: Project, made: Change): Change {
  const pruned = Object.entries(made.project.layout).flatMap(([name, layout]): [string, GraphLayout][] => {
    const graph = getOwn(made.project.graphs, name) ?? EMPTY_GRAPH;
    if (layout === getOwn(before.layout, name) && graph.wires === getOwn(before.graphs, name)?.wires) return [];
    const next = pruneRoutes(graph, layout);
    return next === layout ? [] : [[name, next]];
  });
  if (pruned.length === 0) return made;
  const pruning = change(made.project, (draft) => {
    for (const [name, { reroutes, routes }] of pruned) Object.assign(draftLayout(draft, name), castDraft({ reroutes, routes }));
  });
  return {
    project: pruning.project,
    patches: [...made.patches, ...pruning.patches],
    inverse: [...pruning.inverse, ...made.inverse],
    diagnostics: made.diagnostics,
  };
}
