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
  /** From `makeLayoutId`, or of a reroute that is there. */
  readonly id: string;
  readonly reroute: Reroute;
}

/** One that no route leads through goes with `pruneRoutesAfter`. */
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

/** Leads wires through reroutes; none makes a wire straight. */
export function setRoutes(project: Project, { graph, routes }: SetRoutes): Change {
  return change(project, (draft) => {
    const layout = draftLayout(draft, graph);
    for (const [wire, route] of Object.entries(routes)) {
      if (route.length === 0) delete layout.routes[wire];
      else layout.routes[wire] = [...route];
    }
  });
}

/** The change with what follows for routes where wires or routes are others: `pruneRoutes` says what. */
export function pruneRoutesAfter(before: Project, made: Change): Change {
  const pruned = Object.entries(made.project.layout).flatMap(([name, layout]): [string, GraphLayout][] => {
    const graph = getOwn(made.project.graphs, name) ?? EMPTY_GRAPH;
    if (layout === getOwn(before.layout, name) && graph.wires === getOwn(before.graphs, name)?.wires) return [];
    const next = pruneRoutes(graph, layout);
    return next === layout ? [] : [[name, next]];
  });
  if (pruned.length === 0) return made;
  const settle = change(made.project, (draft) => {
    for (const [name, { reroutes, routes }] of pruned) Object.assign(draftLayout(draft, name), castDraft({ reroutes, routes }));
  });
  return {
    project: settle.project,
    patches: [...made.patches, ...settle.patches],
    inverse: [...settle.inverse, ...made.inverse],
    diagnostics: made.diagnostics,
  };
}
