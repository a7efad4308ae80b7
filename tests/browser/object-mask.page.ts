import { BoxGeometry, DataTexture, Group, Mesh, MeshLambertMaterial, type Object3D, PlaneGeometry, SphereGeometry } from 'three';
import type { DrawBinding } from '../../export/runtime/scene-backend.ts';
import type { ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../nodes/kit/scene-look.ts';
import {
  createStand,
  drawView,
  HEIGHT,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  room,
  sun,
  translation,
  viewOf,
  WIDTH,
} from './scenes-kit.ts';

const FRONT = lookingAt([0, 0, 3], [0, 0, 0]);
const SHADE: SceneLook = { kind: 'shaded', ambient: { value: 1 } };
const stand = createStand();

type Shows = Extract<SceneLook, { kind: 'mask' }>['shows'];

function shoot(items: readonly ObjectItem[], look: SceneLook, occlusion: DrawBinding['occlusion'] = null): Uint8Array {
  const { backend, layer } = stand;
  const scene = backend.serviceFor({ shadowMaps: null, occlusion }).createScene(look);
  scene.update([objects(...items)], [lights(sun([0, 0, 1]))]);
  layer.clear();
  scene.draw(drawView(viewOf(FRONT), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

const mask = (shows: Shows = () => true): SceneLook => ({ kind: 'mask', shows });
const mesh = (geometry: Mesh['geometry'], material = new MeshLambertMaterial()): Mesh => new Mesh(geometry, material);

/** Colors of a mask, and in how many pixels it covers others than a picture of the same objects. */
function compare(white: Uint8Array, picture: Uint8Array) {
  const colors = new Set<string>();
  let differ = 0;
  let covered = 0;
  for (let at = 0; at < white.length; at += 4) {
    colors.add(white.subarray(at, at + 4).join());
    if ((white[at + 3] ?? 0) > 0) covered++;
    if ((white[at + 3] ?? 0) > 0 !== (picture[at + 3] ?? 0) > 0) differ++;
  }
  return { colors: [...colors].sort(), differ, covered, error: stand.gl.getError() };
}

export function silhouette() {
  const root = new Group();
  const bar = mesh(new BoxGeometry(0.4, 1.6, 0.2));
  bar.position.x = 0.5;
  root.add(mesh(new SphereGeometry(0.6)), bar);
  const items = [item(root, { at: translation(-0.2, 0.1, 0) })];
  return compare(shoot(items, mask()), shoot(items, SHADE));
}

/** A sheet with holes cut by its picture. */
export function cutOut() {
  const map = new DataTexture(new Uint8Array([255, 255, 255, 255, 255, 255, 255, 0]), 2, 1);
  map.needsUpdate = true;
  const items = [item(mesh(new PlaneGeometry(1, 1), new MeshLambertMaterial({ map, alphaTest: 0.5 })))];
  return compare(shoot(items, mask()), shoot(items, SHADE));
}

/** A white wall, with something 0.5 m before its left half: a phantom, another object, or a part of the same one. */
export function hidden(by: 'phantom' | 'object' | 'part') {
  const wall = Object.assign(mesh(new PlaneGeometry(9, 9)), { name: 'Wall' });
  const screen = mesh(new PlaneGeometry(9, 9));
  const before = translation(-4.5, 0, 0.5);
  const items: ObjectItem[] = [item(wall)];
  if (by === 'part') {
    screen.applyMatrix4(before);
    wall.add(screen);
    items[0] = item(wall);
  } else items.push(item(screen, { at: before, role: by === 'phantom' ? 'phantom' : 'virtual' }));
  const shows = (_: ObjectItem, part: Object3D): boolean => part === wall || by === 'phantom';
  const pixels = shoot(items, mask(shows));
  return { left: pixel(pixels, 20, HEIGHT / 2), right: pixel(pixels, WIDTH - 20, HEIGHT / 2), error: stand.gl.getError() };
}

/** A wall 3 m away whose left half the room hides; hard, and half-way through a soft border. */
export function occluded(softnessM: number) {
  const depth = room(stand.gl, 2, 1, [2.9, 4]);
  const occlusion = { roomDepth: { views: [depth] }, params: { softnessM: { value: softnessM }, biasM: { value: 0 } } };
  const pixels = shoot([item(mesh(new PlaneGeometry(9, 9)))], mask(), occlusion);
  return { left: pixel(pixels, 20, HEIGHT / 2), right: pixel(pixels, WIDTH - 20, HEIGHT / 2), error: stand.gl.getError() };
}
