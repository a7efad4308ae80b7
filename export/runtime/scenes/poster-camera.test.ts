import { expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, MeshBasicMaterial, PerspectiveCamera, Vector3 } from 'three';
import type { ViewCrop } from '../../../nodes/kit/poster-framing.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import { createPosterCamera, type PosterCameraOptions } from './poster-camera.ts';

const SHAPE = 2;
const SIZE = { widthPx: 1200, heightPx: 600 };
const box = new Mesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshBasicMaterial());

/** Boxes of two nodes and a ground, seen by a camera at eye height. `setHead` moves it. */
function world(options: Partial<PosterCameraOptions> = {}, viewShape = SHAPE) {
  const camera = new PerspectiveCamera(60, viewShape, 0.1, 100);
  camera.position.set(0, 1.5, 3);
  const view = { nearM: 0.1, clipFromView: new Float32Array(16), worldFromView: new Float32Array(16), viewFromWorld: new Float32Array(16) };
  const look = (matrix: Matrix4) => {
    view.clipFromView.set(camera.projectionMatrix.elements);
    view.worldFromView.set(matrix.elements);
    view.viewFromWorld.set(matrix.clone().invert().elements);
  };
  camera.updateMatrixWorld(true);
  look(camera.matrixWorld);
  const item = (key: string, at: Vector3, size = 1, role: ObjectItem['role'] = 'virtual'): ObjectItem => ({
    ...{ key, root: box, role, castsShadow: true, receivesShadow: true },
    worldFromObject: new Matrix4().makeTranslation(at).scale(new Vector3(size, size, size)),
  });
  const list = (...items: ObjectItem[]) => ({ version: 1, items });
  const lists = {
    left: list(item('box', new Vector3(-1, 1.5, 0))),
    right: list(item('box', new Vector3(1, 1.5, 0)), item('room', new Vector3(3, 1, 0), 1, 'phantom'), item('ground', new Vector3(), 100)),
  };
  const operation = (node: string, kind: string, inputs: readonly string[], output?: string) => ({
    ...{ id: node, node, kind, view: 'once', params: {} },
    inputs: { objects: inputs.map((resource) => ({ kind: 'resource', resource })) },
    outputs: output === undefined ? {} : { objects: { kind: 'resource', resource: output } },
  });
  const heads: (Float32Array | null)[] = [];
  const seen = {
    program: {
      operations: [
        operation('left', 'geometry', [], 'left'),
        operation('group/right', 'geometry', [], 'right'),
        operation('scene', 'draw', ['left', 'right']),
      ],
    },
    resources: { get: (id: 'left' | 'right') => ({ kind: 'objects', list: lists[id] }) },
    engine: { state: { frame: { views: [view] } } },
  } as unknown as NonNullable<ReturnType<PosterCameraOptions['inspect']>>;
  const setHead = (head: Float32Array | null) => {
    heads.push(head);
    look(head ? new Matrix4().fromArray(head) : camera.matrixWorld);
  };
  /** Where a point is in the poster, from -1 to 1. */
  const inPoster = (crop: ViewCrop, x: number, y: number, z: number) => {
    const clip = new Vector3(x, y, z).applyMatrix4(new Matrix4().fromArray(view.viewFromWorld)).applyMatrix4(camera.projectionMatrix);
    return [(((clip.x + 1) / 2 - crop.x) / crop.width) * 2 - 1, 1 - (((1 - clip.y) / 2 - crop.y) / crop.height) * 2] as const;
  };
  const poster = createPosterCamera({ inspect: () => seen, setHead, framing: null, nodes: [], size: SIZE, ...options });
  return { poster, heads, inPoster };
}

/** How far the corners of a box reach in the poster: 1 is its edge. */
function reach(inPoster: ReturnType<typeof world>['inPoster'], crop: ViewCrop, x: number): number {
  const corners = [-0.2, 0.2].flatMap((dx) => [-0.2, 0.2].flatMap((dy) => [-0.2, 0.2].map((dz) => inPoster(crop, x + dx, 1.5 + dy, dz))));
  return Math.max(...corners.flatMap(([u, v]) => [Math.abs(u), Math.abs(v)]));
}

test('the head moves so that the objects of the selected nodes fill the poster, and back', () => {
  const { poster, heads, inPoster } = world({ nodes: ['group'] });
  expect(poster.aim()).toEqual(SIZE);
  const crop = poster.crop();
  expect(crop).toEqual({ x: 0, y: 0, width: 1, height: 1 });
  expect(reach(inPoster, crop, 1)).toBeCloseTo(0.72);
  poster.release();
  expect(heads.at(-1)).toBeNull();
});

test('without a selection, all objects are in the poster, without phantoms and grounds', () => {
  const { poster, inPoster } = world();
  poster.aim();
  const farthest = Math.max(reach(inPoster, poster.crop(), 1), reach(inPoster, poster.crop(), -1));
  expect(farthest).toBeGreaterThan(0.65);
  expect(farthest).toBeLessThanOrEqual(0.73);
});

test('where the head cannot be moved, the part of the view around the objects is kept, rendered larger in the shape of the view', () => {
  const viewShape = 4 / 3;
  const { poster, inPoster } = world({ setHead: null, nodes: ['left'] }, viewShape);
  const frame = poster.aim();
  expect(frame.heightPx).toBeGreaterThan(1.5 * SIZE.heightPx);
  expect(frame.widthPx / frame.heightPx).toBeCloseTo(viewShape);
  const crop = poster.crop();
  expect(crop.height * frame.heightPx).toBeCloseTo(SIZE.heightPx, 0);
  expect(crop.width * frame.widthPx).toBeCloseTo(SIZE.widthPx, 0);
  expect(reach(inPoster, crop, -1)).toBeLessThan(0.9);
});

test('a framing that was chosen wins over the selection', () => {
  const half = Math.tan(Math.PI / 6);
  const room = { name: 'studio', eye: [0, 1, 2], target: [0, 1, 1] } as const;
  const { poster, heads } = world({ nodes: ['left'], framing: { center: [0, half / 2], height: half, room } });
  expect(poster.aim()).toEqual({ widthPx: 2 * SIZE.widthPx, heightPx: 2 * SIZE.heightPx });
  expect([...(heads[0] ?? [])].slice(12, 15)).toEqual([0, 1, 2]);
  const { x, y, width, height } = poster.crop();
  expect([x, y, width, height].map((part) => Number(part.toFixed(4)))).toEqual([0.25, 0, 0.5, 0.5]);
});
