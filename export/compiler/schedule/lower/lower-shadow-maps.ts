import type { ResourceId } from '../../../program/program.ts';
import { type FlatNode, sourcesAt } from '../../flat-graph.ts';
import { startValue } from '../slot-allocator.ts';
import { addResource, addStep, type Lowering, resourceAt } from './lowering.ts';

/** The shadow maps that a draw reads, shared by draws with the same casters and lights; null for none. */
export function shadowMapsOf(lowering: Lowering, node: FlatNode): ResourceId | null {
  const { lowering: kind, params } = node.definition;
  if (kind.kind !== 'geometry' || !kind.shadowMap) return null;
  const { casters: ports, lights: lightsPort, enabledBy, chosenBy } = kind.shadowMap;
  const toggle = enabledBy === undefined ? undefined : params[enabledBy];
  if (enabledBy !== undefined && toggle && startValue(node, enabledBy, toggle) === false) return null;
  const choice = chosenBy && params[chosenBy.param];
  if (choice && startValue(node, chosenBy.param, choice) !== chosenBy.value) return null;
  const casters = resourcesAt(lowering, node, ports);
  const lights = resourcesAt(lowering, node, [lightsPort]);
  if (casters.length === 0 || lights.length === 0) return null;
  const resource = `shadows(${casters.join(' ')} | ${lights.join(' ')})`;
  if (lowering.writerOf.has(resource)) return resource;
  addResource(lowering, { id: resource, kind: 'shadow-maps' });
  lowering.writerOf.set(resource, resource);
  const reads = [...casters, ...lights];
  addStep(lowering, { id: resource, node: node.id, kind: 'shadow-maps', view: 'once', reads, writes: [resource], casters, lights });
  return resource;
}

/** The resources connected to the ports, without duplicates. */
function resourcesAt(lowering: Lowering, node: FlatNode, ports: readonly string[]): ResourceId[] {
  return [...new Set(ports.flatMap((port) => sourcesAt(node, port)).map((source) => resourceAt(lowering, source)))];
}
