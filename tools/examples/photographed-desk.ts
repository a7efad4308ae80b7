import { execFile } from 'node:child_process';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import sharp from 'sharp';
import { BoxGeometry, type BufferGeometry, CylinderGeometry } from 'three';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { makeProject, type RecipeNode } from './paper/recipe.ts';
import { CAN, CRATE_M, makeCan, makeCrate } from './play/cans.ts';

/** Boxes of the desk, center and size in meters; the floor is at y = 0, the front is +z. */
const DESK = {
  board: { at: [0, 0.43, 0], size: [1.1, 0.04, 0.5] },
  left: { at: [-0.5, 0.205, 0], size: [0.04, 0.41, 0.46] },
  right: { at: [0.5, 0.205, 0], size: [0.04, 0.41, 0.46] },
  panel: { at: [0, 0.205, -0.1], size: [0.96, 0.41, 0.03] },
} as const satisfies Readonly<Record<string, Box>>;

/** The plate on which the desk stands. */
const PLATE: Box = { at: [0, -0.01, 0], size: [2.5, 0.02, 1.9] };

interface Box {
  readonly at: readonly [x: number, y: number, z: number];
  readonly size: readonly [x: number, y: number, z: number];
}

const WOOD = [0.42, 0.24, 0.12, 1] as const;
const TOP_M = DESK.board.at[1] + DESK.board.size[1] / 2;
const CRATE = { at: [-0.28, TOP_M, 0.02], yawRad: 0.15, scale: 0.7 } as const;
const CANS = [-0.12, 0, 0.12].map((x) => [CRATE.at[0] + x, TOP_M + CRATE.scale * CRATE_M[1] + CAN.heightM / 2, CRATE.at[2]] as const);

/** A desk with a crate and cans, as an ordinary scene. */
function makeScene(library: NodeLibrary): Project {
  const boxes = Object.entries(DESK).flatMap(([name, { at, size }], i): [string, RecipeNode][] => [
    [name, ['objects/primitive', 0, i, { sizeM: size, color: WOOD, roughness: 0.6 }]],
    [`${name}1`, ['objects/transform', 1, i, { positionM: at }]],
  ]);
  const cans = CANS.map((positionM, i): [string, RecipeNode] => [
    `can${i}`,
    ['objects/transform', 1, 7 + i, { positionM, rotationRad: [0, 1.3 * i, 0] }],
  ]);
  const objects = [...Object.keys(DESK).map((name) => `${name}1`), 'crate1', 'tiles', ...cans.map(([name]) => name)];
  return makeProject(library, {
    folder: 'desk',
    figure: 'desk',
    title: 'A desk',
    description: '',
    nodes: {
      ...Object.fromEntries([...boxes, ...cans]),
      crate: ['source/model', 0, 6, { model: 'crate' }],
      crate1: ['objects/transform', 1, 6, { positionM: CRATE.at, rotationRad: [0, CRATE.yawRad, 0], scale: CRATE.scale }],
      can: ['source/model', 0, 7, { model: 'can' }],
      plate: ['objects/primitive', 0, 10, { sizeM: PLATE.size, color: [0.55, 0.53, 0.5, 1] }],
      plate1: ['objects/transform', 1, 10, { positionM: PLATE.at }],
      brick: ['technique/brick', 1, 11, TILES],
      tiles: ['objects/apply-technique', 2, 10],
      light: ['light/directional', 2, 12, SUN],
      scene: ['layer/scene', 3, 0, { ambient: 0.55 }],
      screen: ['output/screen', 4, 0],
    },
    wires: [
      ...Object.keys(DESK).map((name) => `${name}.objects -> ${name}1.objects`),
      'crate.objects -> crate1.objects',
      ...cans.map(([name]) => `can.objects -> ${name}.objects`),
      'plate.objects -> plate1.objects',
      'plate1.objects -> tiles.objects',
      'brick.technique -> tiles.technique',
      ...objects.map((name) => `${name}.objects -> scene.objects`),
      'light.lights -> scene.lights',
      'scene.layer -> screen.layer',
    ],
    assets: { crate: { path: 'assets/crate.glb', kind: 'model' }, can: { path: 'assets/can.glb', kind: 'model' } },
  });
}

/** Params of the light of the scene: from behind the desk on the left, so that what walks there throws its shadow on the desk. */
export const SUN = { azimuthRad: -2.6, elevationRad: 0.55, intensity: 1.4, areaM: 4 } as const;

const TILES = {
  brickM: [0.3, 0.2],
  mortarM: 0.012,
  brickColor: [0.5, 0.5, 0.47, 1],
  mortarColor: [0.75, 0.72, 0.66, 1],
  variation: 0.6,
  bump: 0.2,
} as const;

const CAMERAS = [
  ...['--count', '16', '--center', '0,0.15,0', '--extent', '5,4.2,5', '--elevation', '12..62'],
  ...['--fov', '48', '--size', '512x384'],
];

/**
 * Photographs the desk with `scrim capture` and imports the photographs and a mesh with `scrim import capture`, as anyone would.
 *
 * @returns The files of the capture by their paths in its folder.
 */
export async function photographDesk(root: string, library: NodeLibrary): Promise<Readonly<Record<string, Uint8Array>>> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-desk-'));
  try {
    const scene = join(base, 'scene');
    const photos = join(base, 'desk');
    await write(join(scene, 'project.scrim.json'), saveProject(makeScene(library)).project);
    await write(join(scene, 'assets/crate.glb'), await makeCrate());
    await write(join(scene, 'assets/can.glb'), await makeCan());
    await scrim(root, 'capture', scene, '--out', photos, ...CAMERAS);
    await developAsJpeg(photos);
    await write(join(photos, 'mesh.obj'), meshText());
    await scrim(root, 'import', 'capture', photos, '--project', scene, '--up', '+y', '--depth', 'none');
    const capture = join(scene, 'assets/desk.capture');
    const names = await readdir(capture, { recursive: true, withFileTypes: true });
    const files = names.filter((entry) => entry.isFile()).map(({ parentPath, name }) => relative(capture, join(parentPath, name)));
    return Object.fromEntries(await Promise.all(files.map(async (file) => [file, await readFile(join(capture, file))] as const)));
  } finally {
    await rm(base, { recursive: true, force: true });
  }
}

/** Makes JPEG files of the photographs. Where these are transparent, their colors continue those beside them. */
async function developAsJpeg(photos: string): Promise<void> {
  const images = join(photos, 'images');
  for (const name of await readdir(images)) {
    const file = join(images, name);
    const jpeg = await sharp(file).removeAlpha().jpeg({ quality: 82 }).toBuffer();
    await writeFile(file.replace(/\.png$/, '.jpg'), jpeg);
    await rm(file);
  }
  const cameras = join(photos, 'transforms.json');
  await writeFile(cameras, (await readFile(cameras, 'utf8')).replace(/(images\/\d+)\.png/g, '$1.jpg'));
}

/** Sides of triangles in meters: vertices have the colors of what no photograph shows. */
const GRAIN_M = 0.08;

/** What is photographed, in the place of the scene; crate and cans as their outlines. */
export function deskSurfaces(): readonly BufferGeometry[] {
  const box = ([width, height, depth]: Box['size']): BufferGeometry =>
    new BoxGeometry(width, height, depth, ...[width, height, depth].map((size) => Math.ceil(size / GRAIN_M)));
  const [width, height, depth] = CRATE_M.map((size) => size * CRATE.scale) as unknown as Box['size'];
  const [x, y, z] = CRATE.at;
  return [
    ...[...Object.values(DESK), PLATE].map(({ at, size }) => box(size).translate(...at)),
    box([width, height, depth])
      .rotateY(CRATE.yawRad)
      .translate(x, y + height / 2, z),
    ...CANS.map((at) => new CylinderGeometry(CAN.radiusM, CAN.radiusM, CAN.heightM, 32, 2).translate(...at)),
  ];
}

/** The scene as an OBJ file. */
function meshText(): string {
  const lines: string[] = [];
  let first = 1;
  for (const { index, attributes } of deskSurfaces()) {
    const { array = [], count = 0 } = attributes.position ?? {};
    for (let i = 0; i < 3 * count; i += 3) lines.push(`v ${Array.from(array.slice(i, i + 3), (value) => value.toFixed(5)).join(' ')}`);
    const corners = Array.from(index?.array ?? [], (corner) => corner + first);
    for (let i = 0; i < corners.length; i += 3) lines.push(`f ${corners.slice(i, i + 3).join(' ')}`);
    first += count;
  }
  return `${lines.join('\n')}\n`;
}

/** @throws If the command fails, with what it said. */
async function scrim(root: string, ...args: readonly string[]): Promise<void> {
  await promisify(execFile)(process.execPath, [join(root, 'bin', 'scrim.mjs'), ...args]);
}

async function write(path: string, content: string | Uint8Array): Promise<void> {
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, content);
}
