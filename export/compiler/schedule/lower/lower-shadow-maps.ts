import type { ResourceId } from '../../../program/program.ts';
import { type FlatNode, sourcesAt } from '../../flat-graph.ts';
import { startValue } from '../slots.ts';
import { addResource, addStep, type Lowering, resourceAt } from './lowering.ts';

/** The shadow maps that a draw reads, made when nobody has asked for the same casters and lights before; null for none. */
export function shadowMapsOf(lowering: Lowering, node: FlatNode): ResourceId | null {
  const { lowering: kind, params } = node.definition;
  if (kind.kind !== 'geometry' || !kind.shadowMap) return null;
  const { casters: ports, lights: lightsPort, enabledBy } = kind.shadowMap;
  const toggle = enabledBy === undefined ? undefined : params[enabledBy];
  if (enabledBy !== undefined && toggle && startValue(node, enabledBy, toggle) === false) return null;
  const casters = [...new Set(ports.flatMap((port) => sourcesAt(node, port)).map((source) => resourceAt(lowering, source)))];
  const [lights, ...more] = sourcesAt(node, lightsPort).map((source) => resourceAt(lowering, source));
  if (casters.length === 0 || lights === undefined) return null;
  if (more.length > 0) warnOfMoreLights(lowering, node, lightsPort);
  const resource = `shadows(${casters.join(' ')} | ${lights})`;
  if (lowering.writerOf.has(resource)) return resource;
  addResource(lowering, { id: resource, kind: 'shadow-maps' });
  lowering.writerOf.set(resource, resource);
  const reads = [...casters, lights];
  addStep(lowering, { id: resource, node: node.id, kind: 'shadow-maps', view: 'once', reads, writes: [resource], casters, lights });
  return resource;
}

function warnOfMoreLights({ diagnostics }: Lowering, node: FlatNode, port: string): void {
  const [first] = sourcesAt(node, port);
  const message = `Only the light of ${first?.node} casts shadows in ${node.id}: its other lights shine without.`;
  diagnostics.push({
    code: 'SCR016',
    severity: 'warning',
    nodeId: node.id,
    port,
    message,
    fix: 'Put the light whose shadows you want first.',
  });
}
