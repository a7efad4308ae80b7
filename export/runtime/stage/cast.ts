import type { NodeOperation, Operation, Program, ShadowMapOperation } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { createNodeInstance, type NodeInstance } from '../operations/node-instance.ts';
import { isDraw, nodeKey, shadowMapsKey } from '../operations/node-key.ts';
import { clearOutput, type LiveResources, liveResource } from '../resources/resources.ts';
import type { ShadowMaps } from '../scene-backend.ts';
import type { Slots } from '../values/slots.ts';

/** The nodes and shadow maps of a running program, by the id of their operation. */
export interface Cast {
  readonly resources: LiveResources;
  readonly nodes: ReadonlyMap<string, NodeInstance>;
  readonly shadowMaps: ReadonlyMap<string, KeyedShadowMaps>;
}

interface KeyedShadowMaps {
  readonly key: string;
  readonly resource: string;
  readonly maps: ShadowMaps;
}

/**
 * Makes the cast of a program. Whatever of the cast before is still the same lives on with its state; the rest of it is
 * disposed first, because what takes its place writes into the same lists.
 */
export function createCast(engine: Engine, program: Program, slots: Slots, resources: LiveResources, before: Cast | null): Cast {
  const nodeOperations = program.operations.filter(isNode);
  const mapOperations = program.operations.filter(isShadowMaps);
  const slotType = (slot: number): string => slots.slots[slot]?.type ?? 'none';
  const assetPath = (id: string | null): string | null => program.assets.find((asset) => asset.id === id)?.path ?? null;
  const keys = new Map(nodeOperations.map((operation) => [operation.id, nodeKey(operation, slotType, assetPath)]));

  const keptMaps = new Map<string, KeyedShadowMaps>();
  for (const operation of mapOperations) {
    const old = before?.shadowMaps.get(operation.id);
    if (old?.key === shadowMapsKey(operation) && sameResources(operation, resources, before)) keptMaps.set(operation.id, old);
  }
  const keptMapsOf = (resource: string | null): ShadowMaps | null =>
    [...keptMaps.values()].find((maps) => maps.resource === resource)?.maps ?? null;
  const keptNodes = new Map<string, NodeInstance>();
  for (const operation of nodeOperations) {
    const old = before?.nodes.get(operation.id);
    if (!old || old.key !== keys.get(operation.id) || !sameResources(operation, resources, before)) continue;
    if (isDraw(operation) && old.shadowMaps !== keptMapsOf(operation.shadowMaps)) continue;
    keptNodes.set(operation.id, old);
  }

  if (before) releaseCast(before, keptNodes, keptMaps);
  for (const operation of nodeOperations) {
    if (!keptNodes.has(operation.id)) clearOutputs(operation, resources);
  }

  const nodes = new Map<string, NodeInstance>();
  const shadowMaps = new Map<string, KeyedShadowMaps>();
  const mapsOf = (resource: string | null): ShadowMaps | null =>
    [...shadowMaps.values()].find((maps) => maps.resource === resource)?.maps ?? null;
  for (const operation of program.operations) {
    if (isShadowMaps(operation)) {
      shadowMaps.set(operation.id, keptMaps.get(operation.id) ?? createShadowMaps(engine, operation, resources));
    } else if (isNode(operation)) {
      const kept = keptNodes.get(operation.id);
      const key = keys.get(operation.id) ?? '';
      const maps = isDraw(operation) ? mapsOf(operation.shadowMaps) : null;
      nodes.set(
        operation.id,
        kept?.point(operation, slots) ?? createNodeInstance(engine.host, key, operation, resources, slots, program.assets, maps),
      );
    }
  }
  return { resources, nodes, shadowMaps };
}

/** Disposes all of a cast but what is kept; later nodes may hold on to earlier ones, so they go first. */
export function releaseCast(cast: Cast, keptNodes: ReadonlyMap<string, unknown>, keptMaps: ReadonlyMap<string, unknown>): void {
  for (const [id, node] of [...cast.nodes].reverse()) if (!keptNodes.has(id)) node.dispose();
  for (const [id, { maps }] of cast.shadowMaps) if (!keptMaps.has(id)) maps.dispose();
}

export function isNode(operation: Operation): operation is NodeOperation {
  return operation.kind !== 'pass' && operation.kind !== 'shadow-maps';
}

export function isShadowMaps(operation: Operation): operation is ShadowMapOperation {
  return operation.kind === 'shadow-maps';
}

/** A node is bound to its lists and layers; targets are handed to it with each draw. */
function sameResources(operation: Operation, resources: LiveResources, before: Cast | null): boolean {
  return [...operation.reads, ...operation.writes].every((id) => {
    const resource = resources.get(id);
    return !resource || resource.kind === 'target' || resource.kind === 'shadow-maps' || before?.resources.get(id) === resource;
  });
}

function clearOutputs(operation: NodeOperation, resources: LiveResources): void {
  for (const id of operation.writes) {
    const resource = resources.get(id);
    if (resource) clearOutput(resource);
  }
}

function createShadowMaps(engine: Engine, operation: ShadowMapOperation, resources: LiveResources): KeyedShadowMaps {
  const casters = operation.casters.map((id) => liveResource(resources, id, 'objects').list);
  const lights = liveResource(resources, operation.lights, 'lights').list;
  const [resource = ''] = operation.writes;
  return { key: shadowMapsKey(operation), resource, maps: engine.host.scenes().createShadowMaps(casters, lights) };
}
