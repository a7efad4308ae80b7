import { MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { createGalleryBuilder, type GalleryBuilder } from './gallery-builder.ts';
import { SECTIONS } from './gallery-cells.ts';
import { addBlend, addFilm, addMask, addTrail } from './gallery-layers.ts';
import { addLamps, addSky } from './gallery-lights.ts';
import { MIDDLE_M, moved, WALL_M } from './gallery-place.ts';
import { addSection } from './gallery-sections.ts';
import { addShown } from './gallery-shown.ts';

/** Files in `assets/`, by asset id. */
export const GALLERY_FILES = { sky: 'sky.hdr', film: 'stripes.webm' } as const;

/** Distance of the board behind the cells, and its margin around them, in meters. */
const BOARD = { behindM: 0.075, marginM: 0.02, thickM: 0.02 } as const;

/** Subgraphs that output layers, from the bottom up. */
const LAYERS = [
  ['lamps', 'Lamps'],
  ['sky', 'Evening light'],
  ['mask', 'Mask'],
  ['trail', 'Trail'],
  ['film', 'Film'],
  ['blend', 'Blend modes'],
] as const;

/** A wall of cells, each of which shows a node type. */
export function makeGallery(library: NodeLibrary): Project {
  const wall = createGalleryBuilder(library, 'Board of all nodes');
  const credit = { credit: 'Scrim', licence: 'MIT' };
  wall.asset('sky', { path: `assets/${GALLERY_FILES.sky}`, kind: 'environment', ...credit });
  wall.asset('film', { path: `assets/${GALLERY_FILES.film}`, kind: 'video', ...credit });
  addShown(wall);
  for (const section of SECTIONS) addSection(wall, section);
  addLamps(wall, 7, [0, 1]);
  addSky(wall, 7, [2, 3]);
  addMask(wall, 7, 4);
  addTrail(wall, 7, 5);
  addFilm(wall, 8, 0);
  addBlend(wall, 8, 2);
  addMain(wall);
  return wall.finish();
}

const NODE_PX = { x: 270, y: 210 } as const;

function addMain(wall: GalleryBuilder): void {
  const [column, line] = [NODE_PX.x, NODE_PX.y];
  wall.into(MAIN_GRAPH);
  SECTIONS.forEach(({ name }, i) => {
    wall.add(`${name}-all`, `graph/${name}`, { x: 0, y: i * line });
  });
  addBoard(wall, SECTIONS.length * line);
  wall.add('sun-all', 'light/directional', { x: column, y: (SECTIONS.length + 2) * line }, { intensity: 0.6 });
  wall.add('wall-all', 'layer/scene', { x: 2.2 * column, y: 0 }, { ambient: 0.8, shadows: false });
  for (const { name } of SECTIONS) wall.wire(`${name}-all.objects -> wall-all.objects`);
  wall.wire('stand-board.objects -> wall-all.objects');
  wall.wire('sun-all.lights -> wall-all.lights');
  wall.frame('Values, pulses, controls and techniques: cells of one scene', {
    x: -30,
    y: -60,
    width: 3.2 * column + 60,
    height: (SECTIONS.length + 3) * line + 60,
  });

  const left = 3.8 * column;
  let below = 'wall-all.layer';
  LAYERS.forEach(([name], i) => {
    wall.add(`${name}-all`, `graph/${name}`, { x: left, y: (i + 1) * line });
    wall.add(`over-${name}`, 'operator/over', { x: left + (i + 1.3) * column, y: 0 });
    wall.wire(`${name}-all.layer -> over-${name}.top`);
    wall.wire(`${below} -> over-${name}.bottom`);
    below = `over-${name}.layer`;
  });
  // Six layers are render targets. With four samples each, they would take some 400 MB on a phone.
  wall.add(
    'screen-all',
    'output/screen',
    { x: left + (LAYERS.length + 1.6) * column, y: 0 },
    {
      antialias: false,
      aroundHeightM: MIDDLE_M[1],
      aroundAheadM: -MIDDLE_M[2],
      aroundDistanceM: 1.55,
    },
  );
  wall.wire(`${below} -> screen-all.layer`);
  wall.frame('Lights and layers: each one is a layer over those before', {
    x: left - 30,
    y: -60,
    width: (LAYERS.length + 2.6) * column + 60,
    height: (LAYERS.length + 1.4) * line + 60,
  });
}

/** A dark board, so that the cells are visible in any room. */
function addBoard(wall: GalleryBuilder, y: number): void {
  const { behindM, marginM, thickM } = BOARD;
  wall.add(
    'shape-board',
    'objects/primitive',
    { x: 0, y },
    {
      sizeM: [WALL_M.width + 2 * marginM, WALL_M.height + 2 * marginM, thickM],
      color: [0.12, 0.13, 0.16, 1],
      roughness: 1,
    },
  );
  wall.add('stand-board', 'objects/transform', { x: NODE_PX.x, y }, { positionM: [...moved(MIDDLE_M, 0, 0, -behindM)] });
  wall.wire('shape-board.objects -> stand-board.objects');
}
