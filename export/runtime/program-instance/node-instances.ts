import type { NodeOperation, Operation, Program, ShadowMapOperation } from '../../program/program.ts';
import type { Engine } from '../engine.ts';
import { createNodeInstance, type NodeInstance } from '../operations/node-instance.ts';
import { isDraw, nodeKey, shadowMapsKey } from '../operations/node-key.ts';
import { clearOutput, type LiveResource, type LiveResources, liveResource } from '../resources/resources.ts';
import type { ShadowMaps } from '../scene-backend.ts';
import type { Slots } from '../values/slots.ts';

/** The nodes and shadow maps of a running program, by the id of their operation. */
export interface NodeInstances {
  readonly resources: LiveResources;
  readonly nodes: ReadonlyMap<string, NodeInstance>;
  readonly shadowMaps: ReadonlyMap<string, KeyedShadowMaps>;
}

interface KeyedShadowMaps {
  readonly key: string;
  readonly resource: string;
  readonly maps: ShadowMaps;
}

type Members = Pick<NodeInstances, 'nodes' | 'shadowMaps'>;

/**
 * Creates the nodes and shadow maps of a program. Those of `before` that are unchanged are kept with their state. The others are
 * disposed first, because their replacements write into the same lists.
 */
export function createNodeInstances(
  engine: Engine,
  program: Program,
  slots: Slots,
  resources: LiveResources,
  before: NodeInstances | null,
): NodeInstances {
  const slotType = (slot: number): string => slots.slots[slot]?.type ?? 'none';
  const assetPath = (id: string | null): string | null => program.assets.find((asset) => asset.id === id)?.path ?? null;
  const keyOf = (operation: NodeOperation): string => nodeKey(operation, slotType, assetPath);
  const kept = before ? findKept(program, resources, before, keyOf) : NOBODY;
  if (before) disposeNodeInstances(before, kept);
  for (const operation of program.operations) {
    if (isNode(operation) && !kept.nodes.has(operation.id)) clearOutputs(operation, resources);
  }

  const nodes = new Map<string, NodeInstance>();
  const shadowMaps = new Map<string, KeyedShadowMaps>();
  for (const operation of program.operations) {
    if (isShadowMaps(operation)) {
      shadowMaps.set(operation.id, kept.shadowMaps.get(operation.id) ?? createShadowMaps(engine, operation, resources));
    } else if (isNode(operation)) {
      const old = kept.nodes.get(operation.id);
      old?.point(operation, resources, slots);
      const maps = mapsOf(operation, shadowMaps);
      nodes.set(operation.id, old ?? createNodeInstance(engine.host, keyOf(operation), operation, resources, slots, program.assets, maps));
    }
  }
  return { resources, nodes, shadowMaps };
}

const NOBODY: Members = { nodes: new Map(), shadowMaps: new Map() };

function findKept(program: Program, resources: LiveResources, before: NodeInstances, keyOf: (operation: NodeOperation) => string): Members {
  const shadowMaps = new Map<string, KeyedShadowMaps>();
  for (const operation of program.operations.filter(isShadowMaps)) {
    const old = before.shadowMaps.get(operation.id);
    if (old?.key === shadowMapsKey(operation) && sameResources(operation, resources, before)) shadowMaps.set(operation.id, old);
  }
  const nodes = new Map<string, NodeInstance>();
  for (const operation of program.operations.filter(isNode)) {
    const old = before.nodes.get(operation.id);
    const same = old?.key === keyOf(operation) && old.shadowMaps === mapsOf(operation, shadowMaps);
    if (old && same && sameResources(operation, resources, before)) nodes.set(operation.id, old);
  }
  return { nodes, shadowMaps };
}

/** The shadow maps that a drawing operation reads; null for none and for other operations. */
function mapsOf(operation: NodeOperation, shadowMaps: NodeInstances['shadowMaps']): ShadowMaps | null {
  if (!isDraw(operation) || operation.shadowMaps === null) return null;
  for (const { resource, maps } of shadowMaps.values()) if (resource === operation.shadowMaps) return maps;
  return null;
}

/** Disposes everything except `kept`. Later nodes are disposed first, because they may refer to earlier ones. */
export function disposeNodeInstances(instances: NodeInstances, kept: Members = NOBODY): void {
  for (const [id, node] of [...instances.nodes].reverse()) if (!kept.nodes.has(id)) node.dispose();
  for (const [id, { maps }] of instances.shadowMaps) if (!kept.shadowMaps.has(id)) maps.dispose();
}

/**
 * Whether a node is a value node, which survives the loss of the context. Other nodes hold GPU objects of three.js, if only through their
 * outputs.
 */
export function makesValues({ operations }: Program, id: string): boolean {
  return operations.some((operation) => operation.id === id && (operation.kind === 'value' || operation.kind === 'behavior'));
}

export function isNode(operation: Operation): operation is NodeOperation {
  return operation.kind !== 'pass' && operation.kind !== 'shadow-maps' && operation.kind !== 'readback';
}

export function isShadowMaps(operation: Operation): operation is ShadowMapOperation {
  return operation.kind === 'shadow-maps';
}

/**
 * Whether the resources of a node are unchanged. A node keeps its lists and layers; targets are passed with each draw, and pulses are
 * connected again.
 */
function sameResources(operation: Operation, resources: LiveResources, before: NodeInstances): boolean {
  const stays = (id: string): boolean => {
    const resource = resources.get(id);
    return !resource || resource.kind === 'target' || resource.kind === 'shadow-maps' || before.resources.get(id) === resource;
  };
  return operation.reads.every((id) => isPointed(resources.get(id)) || stays(id)) && operation.writes.every(stays);
}

/** Whether wires of a resource of this kind are connected to a kept node again, so that the resource may change. */
function isPointed(resource: LiveResource | undefined): boolean {
  return resource?.kind === 'pulses' || resource?.kind === 'pose';
}

function clearOutputs(operation: NodeOperation, resources: LiveResources): void {
  for (const id of operation.writes) {
    const resource = resources.get(id);
    if (resource) clearOutput(resource);
  }
}

function createShadowMaps(engine: Engine, operation: ShadowMapOperation, resources: LiveResources): KeyedShadowMaps {
  const casters = operation.casters.map((id) => liveResource(resources, id, 'objects').list);
  const lights = operation.lights.map((id) => liveResource(resources, id, 'lights').list);
  const [resource = ''] = operation.writes;
  return { key: shadowMapsKey(operation), resource, maps: engine.host.scenes().createShadowMaps(casters, lights) };
}
