import { expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, MeshBasicMaterial, PerspectiveCamera } from 'three';
import type { ObjectItem, ObjectList } from '../../../nodes/kit/scene-lists.ts';
import type { NodeOperation } from '../../program/program.ts';
import type { Inspected } from '../inspected.ts';
import type { LiveResource } from '../resources/resources.ts';
import { firstInput, pickObject, placedObjects, poseInto } from './placed-objects.ts';

const unitBox = new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial());
const move = (x: number, y: number, z: number) => new Matrix4().makeTranslation(x, y, z);

function list(...items: ObjectItem[]): ObjectList {
  return { version: 1, items };
}

function item(key: string, worldFromObject: Matrix4, role: ObjectItem['role'] = 'virtual'): ObjectItem {
  return { key, root: unitBox, worldFromObject, role, castsShadow: true, receivesShadow: true };
}

function operation(node: string, kind: NodeOperation['kind'], inputs: readonly string[], output: string | null): NodeOperation {
  return {
    id: node,
    node,
    kind,
    type: `test/${node}`,
    reads: inputs,
    writes: output === null ? [] : [output],
    view: 'once',
    inputs: { objects: inputs.map((resource) => ({ kind: 'resource', resource })) },
    multiple: ['objects'],
    outputs: output === null ? {} : { objects: { kind: 'resource', resource: output } },
    params: {},
    config: {},
    assets: {},
  };
}

/** One box, moved to the left by one node and to the right and away by two others; a scene draws both. */
function world() {
  const left = move(-1, 0, 0);
  const right = move(1, 0, 0);
  const away = move(0, 0, -2).multiply(right);
  const lists: Record<string, ObjectList> = {
    box: list(item('box', new Matrix4())),
    left: list(item('0/box', left)),
    right: list(item('0/box', right)),
    away: list(item('0/0/box', away)),
  };
  const operations = [
    operation('box', 'geometry', [], 'box'),
    operation('left', 'geometry', ['box'], 'left'),
    operation('right', 'geometry', ['box'], 'right'),
    operation('away', 'geometry', ['right'], 'away'),
    operation('scene', 'draw', ['left', 'away'], null),
  ];
  const resources = new Map<string, LiveResource>(Object.entries(lists).map(([id, made]) => [id, { kind: 'objects', list: made }]));
  const camera = new PerspectiveCamera(90, 1, 0.1, 100);
  camera.position.set(0, 0, 3);
  camera.updateMatrixWorld(true);
  const view = {
    clipFromView: new Float32Array(camera.projectionMatrix.elements),
    worldFromView: new Float32Array(camera.matrixWorld.elements),
  };
  const seen = { program: { operations }, resources, engine: { state: { frame: { views: [view] } } } } as unknown as Inspected;
  return { lists, seen };
}

function after(seen: Inspected, node: string, way: readonly string[] = []): number[] {
  const out = new Matrix4();
  expect(placedObjects(seen, node, way, out)).toBe(true);
  return out.elements.slice(12, 15);
}

test('what comes after a node is what later nodes do to its objects, on the way that is asked for', () => {
  const { seen } = world();
  expect(after(seen, 'box')).toEqual([-1, 0, 0]);
  expect(after(seen, 'box', ['right'])).toEqual([1, 0, -2]);
  expect(after(seen, 'right')).toEqual([0, 0, -2]);
  expect(after(seen, 'away')).toEqual([0, 0, 0]);
  // A light places no objects.
  expect(after(seen, 'lamp')).toEqual([0, 0, 0]);
});

test('of objects without a size it cannot be told, and of none there is nothing to tell', () => {
  const { seen, lists } = world();
  lists.right?.items[0]?.worldFromObject.makeScale(0, 0, 0);
  const out = move(5, 5, 5);
  expect(placedObjects(seen, 'right', [], out)).toBe(false);
  expect(out.elements[12]).toBe(5);
  lists.box?.items.splice(0);
  expect(after(seen, 'box')).toEqual([0, 0, 0]);
});

test('a click finds the nearest object, and the nodes that it went through', () => {
  const { seen, lists } = world();
  // From 3 m, 90° wide: the left box is at u = 0.5 - 1 / 6, the right one, at 5 m, at 0.5 + 1 / 10.
  expect(pickObject(seen, 0, 0.33, 0.5)).toEqual({ way: ['box', 'left', 'scene'], role: 'virtual' });
  expect(pickObject(seen, 0, 0.6, 0.5)).toEqual({ way: ['box', 'right', 'away', 'scene'], role: 'virtual' });
  expect(pickObject(seen, 0, 0.5, 0.9)).toBe(null);
  expect(pickObject(seen, 1, 0.5, 0.5)).toBe(null);
  // Brought before the other, it is the one.
  const front = lists.left?.items[0];
  if (!front) throw new Error('There is no box.');
  front.worldFromObject.copy(move(0.45, 0, 0));
  front.role = 'phantom';
  expect(pickObject(seen, 0, 0.6, 0.5)).toEqual({ way: ['box', 'left', 'scene'], role: 'phantom' });
});

test('a click on one of several instances finds the node that made what they repeat, which they read', () => {
  const { seen, lists } = world();
  const instances = new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial());
  lists.right?.items.splice(0, 1, { ...item('0/box', move(0, 2, 0)), root: instances });
  lists.away?.items.splice(0);
  lists.left?.items.splice(0);
  const scene = operation('scene', 'draw', ['right'], null);
  const drawn = {
    ...seen,
    program: { ...seen.program, operations: [...seen.program.operations.filter(({ id }) => id !== 'scene'), scene] },
  };
  expect(pickObject(drawn, 0, 0.5, 5 / 6)?.way).toEqual(['box', 'right', 'scene']);
  expect(firstInput(seen, 'right')?.key).toBe('box');
  expect(firstInput(seen, 'box')).toBeUndefined();
});

test('the pose of a node is the one that it reads', () => {
  const { seen } = world();
  const pose = { worldFromPose: new Float32Array(move(1, 2, 3).elements), valid: true, jumps: 0 };
  const operations = [operation('offset', 'value', ['head'], 'moved'), operation('head', 'value', [], 'head')];
  const posed = { program: { ...seen.program, operations }, resources: new Map<string, LiveResource>([['head', { kind: 'pose', pose }]]) };
  expect(poseInto(posed, 'offset')).toBe(pose);
  expect(poseInto(posed, 'head')).toBeUndefined();
});
