import type { WireType } from '../../nodes/kit/wire-types.ts';
import { portCenter } from '../state/graph/node-shape.ts';
import type { CanvasNode } from './project-canvas.ts';
import type { RerouteNode } from './project-reroutes.ts';
import type { CanvasWire } from './project-wires.ts';
import { stretchPath } from './wire-path.ts';

type WireEnd = CanvasNode | RerouteNode;

interface KnownPath {
  readonly source: WireEnd;
  readonly target: WireEnd;
  readonly path: string;
}

/** Makes one SVG path per wire type. Caches the path of each wire until one of its ends moves. */
export function createOverviewPaths(): (nodes: readonly WireEnd[], wires: readonly CanvasWire[]) => ReadonlyMap<WireType, string> {
  let known = new Map<string, KnownPath>();
  return (nodes, wires) => {
    const byId = new Map(nodes.map((node) => [node.id, node]));
    const next: typeof known = new Map();
    const parts = new Map<WireType, string[]>();
    for (const wire of wires) {
      const source = byId.get(wire.source);
      const target = byId.get(wire.target);
      if (!source || !target) continue;
      const before = known.get(wire.id);
      const path = before?.source === source && before.target === target ? before : { source, target, path: pathOf(wire, source, target) };
      next.set(wire.id, path);
      const type = wire.data?.from ?? 'number';
      const list = parts.get(type) ?? [];
      list.push(path.path);
      parts.set(type, list);
    }
    known = next;
    return new Map([...parts].map(([type, list]) => [type, list.join('')]));
  };
}

function pathOf(wire: CanvasWire, source: WireEnd, target: WireEnd): string {
  const from = placeOf(source, wire.sourceHandle, 'output');
  const to = placeOf(target, wire.targetHandle, 'input');
  if (!from || !to) return '';
  const ends = { sourceX: from.x, sourceY: from.y, targetX: to.x, targetY: to.y };
  return stretchPath({ ...ends, fromReroute: source.type === 'reroute', toReroute: target.type === 'reroute' });
}

function placeOf({ position, type, data }: WireEnd, name: string | null | undefined, side: 'input' | 'output') {
  if (type === 'reroute') return position;
  const port = data.shape.ports.find((candidate) => candidate.side === side && candidate.name === name);
  if (!port) return null;
  const center = portCenter(data.shape, port);
  return { x: position.x + center.x, y: position.y + center.y };
}
