import type { Graph, GraphLayout, PortAddress, Wire } from './project.ts';
import { getOwn } from './record.ts';
import { printAddress, printWire } from './wires.ts';

/** What is drawn of wires between two points of their ways; all wires that run there share it. */
export interface Stretch {
  /** The output that its wires come from. */
  readonly source: PortAddress;
  /** Never empty. More than one only where it leads to a reroute. */
  readonly wires: readonly [Wire, ...Wire[]];
  /** The reroutes up to it, from the source on. */
  readonly before: readonly string[];
  /** The reroute that it leads to; null where that is the target of its one wire. */
  readonly to: string | null;
}

const STRAIGHT: readonly string[] = [];

export function routeOf({ routes }: Pick<GraphLayout, 'routes'>, wire: Wire): readonly string[] {
  return getOwn(routes, printWire(wire)) ?? STRAIGHT;
}

/** Unlike any other of the graph: that which ends at a target is called as its wire is. */
export function stretchId({ source, wires, before, to }: Stretch): string {
  return to === null ? printWire(wires[0]) : `${printAddress(source)} via ${before.at(-1) ?? 'nothing'} to ${to}`;
}

/** All that is drawn, by id; the stretches of a wire in their order. Routes must be pruned. */
export function stretchesOf({ wires }: Pick<Graph, 'wires'>, layout: Pick<GraphLayout, 'routes'>): ReadonlyMap<string, Stretch> {
  const stretches = new Map<string, Stretch>();
  for (const wire of wires) {
    const route = routeOf(layout, wire);
    for (let at = 0; at <= route.length; at++) {
      const stretch: Stretch = { source: wire.from, wires: [wire], before: route.slice(0, at), to: route[at] ?? null };
      const id = stretchId(stretch);
      const known = stretches.get(id);
      stretches.set(id, known ? { ...known, wires: [...known.wires, wire] } : stretch);
    }
  }
  return stretches;
}

/** The wires that are led through a reroute. */
export function wiresThrough({ wires }: Pick<Graph, 'wires'>, layout: Pick<GraphLayout, 'routes'>, reroute: string): readonly Wire[] {
  return wires.filter((wire) => routeOf(layout, wire).includes(reroute));
}

/** Routes of wires that have become others: a wire that is in no pair keeps its own. */
export function routesAfter(
  routes: GraphLayout['routes'],
  replaced: readonly (readonly [before: Wire, after: Wire])[],
): GraphLayout['routes'] {
  const next = { ...routes };
  for (const [before] of replaced) delete next[printWire(before)];
  for (const [before, after] of replaced) {
    const route = getOwn(routes, printWire(before));
    if (route) next[printWire(after)] = route;
  }
  return next;
}

/**
 * The layout with the routes that can be drawn: of wires that are there, through reroutes that are there, each of which is reached in one
 * way alone, as the branches of a tree. Reroutes on no route go. The same object where nothing had to.
 */
export function pruneRoutes({ wires }: Pick<Graph, 'wires'>, layout: GraphLayout): GraphLayout {
  if (Object.keys(layout.routes).length + Object.keys(layout.reroutes).length === 0) return layout;
  /** Reroute → what wires come to it from. */
  const reachedFrom = new Map<string, string>();
  const routes: Record<string, readonly string[]> = {};
  let loose = Object.keys(layout.routes).length;
  for (const wire of wires) {
    const route = routeOf(layout, wire);
    if (route.length === 0) continue;
    let last = printAddress(wire.from);
    const kept = route.filter((reroute) => {
      const known = reachedFrom.get(reroute) ?? last;
      if (known !== last || getOwn(layout.reroutes, reroute) === undefined) return false;
      reachedFrom.set(reroute, last);
      last = reroute;
      return true;
    });
    if (kept.length > 0) routes[printWire(wire)] = kept.length === route.length ? route : kept;
    if (kept.length === route.length) loose--;
  }
  const used = Object.entries(layout.reroutes).filter(([id]) => reachedFrom.has(id));
  const isSettled = loose === 0 && used.length === Object.keys(layout.reroutes).length;
  return isSettled ? layout : { ...layout, routes, reroutes: Object.fromEntries(used) };
}
