import { Matrix4, Raycaster, Vector2, Vector3 } from 'three';
import type { PoseView } from '../../../nodes/kit/pose.ts';
import type { ObjectItem, ObjectList } from '../../../nodes/kit/scene-lists.ts';
import type { NodeOperation, Operation } from '../../program/program.ts';
import type { Inspected } from '../inspected.ts';

/** The last frame, as `player.inspect` returns it (`inspected.ts`). */
type Seen = Pick<Inspected, 'program' | 'resources'>;

// Each is valid within one call.
const scratchMatrix = new Matrix4();
const scratchPoint = new Vector3();
const scratchPointer = new Vector2();
const scratchRaycaster = new Raycaster();

/**
 * Writes to `out` the transform that later nodes apply to the objects of a node, as `worldFromParent`: the identity if no node transforms
 * them, or if the node has no objects. If the objects pass through the graph on several paths, the one through the nodes of `way` counts,
 * else the first. Returns false, and leaves `out` unchanged, if the transform cannot be determined because the objects are scaled to no
 * size.
 */
export function placedObjects(seen: Seen, node: string, way: readonly string[], out: Matrix4): boolean {
  const own = listsOf(seen).find(({ operation }) => operation.node === node);
  const [item] = own?.list.items ?? [];
  if (!own || !item) {
    out.identity();
    return true;
  }
  if (Math.abs(item.worldFromObject.determinant()) < Number.EPSILON) return false;
  let last = { operation: own.operation, list: own.list, item };
  for (;;) {
    const next = nextOf(seen, last.list, last.item, way);
    if (!next) break;
    last = next;
  }
  out.multiplyMatrices(last.item.worldFromObject, scratchMatrix.copy(item.worldFromObject).invert());
  return true;
}

/** The first object that a node reads; undefined if there is none. */
export function firstInput(seen: Seen, node: string): ObjectItem | undefined {
  const operation = seen.program.operations.filter(isNode).find((candidate) => candidate.node === node);
  return operation && objectsInto(seen, operation).find(({ items }) => items.length > 0)?.items[0];
}

/** The pose that a node reads, if it reads one: the handles of the node are in its axes. */
export function poseInto({ program, resources }: Seen, node: string): PoseView | undefined {
  const refs = program.operations.filter(isNode).flatMap(({ node: owner, inputs }) => (owner === node ? Object.values(inputs).flat() : []));
  for (const ref of refs) {
    const resource = ref.kind === 'resource' ? resources.get(ref.resource) : undefined;
    if (resource?.kind === 'pose') return resource.pose;
  }
  return undefined;
}

/** An object at a point of a view. */
export interface PickedObject {
  /** Ids of the nodes on its path, from the one that created it to the one that drew it. */
  readonly way: readonly string[];
  readonly role: ObjectItem['role'];
}

/** The nearest object at a point of a view; `u` and `v` are fractions of its size from the bottom left. Null if there is none. */
export function pickObject(inspected: Seen & Pick<Inspected, 'engine'>, viewIndex: number, u: number, v: number): PickedObject | null {
  const view = inspected.engine.state.frame.views[viewIndex];
  if (!view) return null;
  const { ray } = scratchRaycaster;
  scratchPointer.set(2 * u - 1, 2 * v - 1);
  const worldFromClip = new Matrix4().fromArray(view.worldFromView).multiply(scratchMatrix.fromArray(view.clipFromView).invert());
  const from = new Vector3().setFromMatrixPosition(scratchMatrix.fromArray(view.worldFromView));
  const towards = new Vector3(scratchPointer.x, scratchPointer.y, 0.5).applyMatrix4(worldFromClip).sub(from).normalize();
  let nearestM = Number.POSITIVE_INFINITY;
  let found: { readonly draw: NodeOperation; readonly list: ObjectList; readonly item: ObjectItem } | null = null;
  for (const draw of inspected.program.operations) {
    if (draw.kind !== 'draw') continue;
    for (const list of objectsInto(inspected, draw)) {
      for (const item of list.items) {
        if (item.hidden) continue;
        // The subtree is stored as if it were at the origin, so the ray is transformed.
        const objectFromWorld = scratchMatrix.copy(item.worldFromObject).invert();
        ray.origin.copy(from).applyMatrix4(objectFromWorld);
        ray.direction.copy(towards).transformDirection(objectFromWorld);
        const [hit] = scratchRaycaster.intersectObject(item.root, true);
        if (!hit) continue;
        const distanceM = scratchPoint.copy(hit.point).applyMatrix4(item.worldFromObject).distanceTo(from);
        if (distanceM >= nearestM) continue;
        nearestM = distanceM;
        found = { draw, list, item };
      }
    }
  }
  return found && { way: [...wayTo(inspected, found.list, found.item), found.draw.node], role: found.item.role };
}

/** All objects that are drawn, each with the ids of the nodes on its path. */
export function drawnObjects(seen: Seen): readonly { readonly way: readonly string[]; readonly item: ObjectItem }[] {
  return seen.program.operations
    .filter((operation): operation is NodeOperation => operation.kind === 'draw')
    .flatMap((draw) =>
      objectsInto(seen, draw).flatMap((list) => list.items.map((item) => ({ way: [...wayTo(seen, list, item), draw.node], item }))),
    );
}

interface Placed {
  readonly operation: NodeOperation;
  readonly list: ObjectList;
}

function listsOf({ program, resources }: Seen): Placed[] {
  return program.operations.filter(isNode).flatMap((operation) =>
    Object.values(operation.outputs).flatMap((output) => {
      const resource = output.kind === 'resource' ? resources.get(output.resource) : undefined;
      return resource?.kind === 'objects' ? [{ operation, list: resource.list }] : [];
    }),
  );
}

function objectsInto({ resources }: Seen, { inputs }: NodeOperation): ObjectList[] {
  return Object.values(inputs).flatMap((refs) =>
    refs.flatMap((ref) => {
      const resource = ref.kind === 'resource' ? resources.get(ref.resource) : undefined;
      return resource?.kind === 'objects' ? [resource.list] : [];
    }),
  );
}

/** Finds the item that a later node, preferably one of `way`, derives from an item: both have the same subtree. */
function nextOf(seen: Seen, list: ObjectList, item: ObjectItem, way: readonly string[]) {
  const readers = listsOf(seen).flatMap(({ operation, list: derived }) => {
    const index = objectsInto(seen, operation).indexOf(list);
    const same = index === -1 ? undefined : derivedFrom(derived, item, index);
    return same ? [{ operation, list: derived, item: same }] : [];
  });
  return readers.find(({ operation }) => way.includes(operation.node)) ?? readers[0];
}

function derivedFrom(derived: ObjectList, { root, key }: ObjectItem, index: number): ObjectItem | undefined {
  const candidates = derived.items.filter((item) => item.root === root);
  // The name that `deriveObjects` gives if a subtree occurs several times.
  return candidates.find((item) => item.key === `${index}/${key}`) ?? candidates[0];
}

function wayTo(seen: Seen, list: ObjectList, item: ObjectItem): string[] {
  const made = listsOf(seen).find((candidate) => candidate.list === list);
  if (!made) return [];
  const inputs = objectsInto(seen, made.operation);
  for (const [index, input] of inputs.entries()) {
    const named = input.items.filter(({ key }) => item.key === `${index}/${key}`);
    // Instances have a subtree of their own, and the name of what they copy.
    const source = named.find(({ root }) => root === item.root) ?? named[0];
    const before = source ?? input.items.find(({ root }) => root === item.root);
    if (before && (source || inputs.length === 1)) return [...wayTo(seen, input, before), made.operation.node];
  }
  return [made.operation.node];
}

function isNode(operation: Operation): operation is NodeOperation {
  return operation.kind !== 'pass' && operation.kind !== 'shadow-maps' && operation.kind !== 'readback';
}
