import type { Graph, GraphLayout, PortAddress, Wire } from './project.ts';
import { getOwn } from './record.ts';
import { printAddress, printWire } from './wires.ts';

/** A segment of routes between two of their points, shared by all wires that pass along it. */
export interface Stretch {
  /** The output at the start of its wires. */
  readonly source: PortAddress;
  /** Never empty; more than one only if the segment ends at a reroute. */
  readonly wires: readonly [Wire, ...Wire[]];
  /** The reroutes before it, from the source on. */
  readonly before: readonly string[];
  /** The reroute at its end; null at the target of its only wire. */
  readonly to: string | null;
}

const STRAIGHT: readonly string[] = [];

/**
 * @returns The reroutes of a wire from source to target; empty for a direct wire.
 *
 * @example
 * routeOf(layout, wire); // ['reroute-p3m9']
 */
export function routeOf({ routes }: Pick<GraphLayout, 'routes'>, wire: Wire): readonly string[] {
  return getOwn(routes, printWire(wire)) ?? STRAIGHT;
}

/** Unique id of a segment within its graph. A segment that ends at a target has the id of its wire. */
export function stretchId({ source, wires, before, to }: Stretch): string {
  return to === null ? printWire(wires[0]) : `${printAddress(source)} via ${before.at(-1) ?? 'nothing'} to ${to}`;
}

/**
 * @returns All segments of a graph by id, those of a wire in order. Requires pruned routes.
 *
 * @example
 * // One wire through one reroute.
 * [...stretchesOf(graph, layout).values()].map(({ to }) => to); // ['reroute-p3m9', null]
 */
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

/**
 * @returns The wires whose route contains the reroute.
 *
 * @example
 * wiresThrough(graph, layout, 'reroute-p3m9').map(printWire); // ['video-a1b2.layer -> sepia-k7q2.inputImage']
 */
export function wiresThrough({ wires }: Pick<Graph, 'wires'>, layout: Pick<GraphLayout, 'routes'>, reroute: string): readonly Wire[] {
  return wires.filter((wire) => routeOf(layout, wire).includes(reroute));
}

/** Moves the routes of replaced wires; other wires keep theirs. */
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
 * Removes the routes of missing wires, and from other routes the reroutes that are missing or that were reached along another path before.
 * Reroutes without a route are removed too.
 *
 * @returns The layout, or the same object if nothing was invalid.
 *
 * @example
 * pruneRoutes({ wires: [] }, layout); // { ...layout, routes: {}, reroutes: {} }
 */
export function pruneRoutes({ wires }: Pick<Graph, 'wires'>, layout: GraphLayout): GraphLayout {
  if (Object.keys(layout.routes).length + Object.keys(layout.reroutes).length === 0) return layout;
  /** Reroute → the point before it. */
  const reachedFrom = new Map<string, string>();
  const routes: Record<string, readonly string[]> = {};
  let invalidRoutes = Object.keys(layout.routes).length;
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
    if (kept.length === route.length) invalidRoutes--;
  }
  const used = Object.entries(layout.reroutes).filter(([id]) => reachedFrom.has(id));
  const isValid = invalidRoutes === 0 && used.length === Object.keys(layout.reroutes).length;
  return isValid ? layout : { ...layout, routes, reroutes: Object.fromEntries(used) };
}
