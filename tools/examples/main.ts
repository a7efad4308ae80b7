import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { bundleScript } from '../../app/services/bundle-script.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';
import type { ToolMain } from '../lib/tool.ts';
import { makeChime } from './chime.ts';
import { makeElephant } from './elephant.ts';
import { GALLERY_FILES, makeGallery } from './gallery.ts';
import { makeGlossyBall } from './glossy-ball.ts';
import { LAMP_AND_WINDOW, makeLampAndWindow } from './lamp-and-window.ts';
import { makeLitRoom, makeLitRoomShot } from './lit-room.ts';
import { makeLectern, makeNight, makePages, makePanes, makeValley } from './paper/book.ts';
import { makeBracket } from './paper/bracket.ts';
import { makeHands } from './paper/hands.ts';
import { makeProject } from './paper/recipe.ts';
import { RECIPES } from './paper/recipes.ts';
import { photographDesk } from './photographed-desk.ts';
import { makePinwheel } from './pinwheel.ts';
import { makeBall, makeCan, makeCrate } from './play/cans.ts';
import { MARBLES, makeBase, makeChutes, makeMarble, makeStand } from './play/marble-run.ts';
import { PLAY } from './play/recipes.ts';
import { makeRobot } from './robot.ts';
import { makeRobotAndDesk, ROBOT_AND_DESK } from './robot-and-desk.ts';
import { makeSky } from './sky.ts';
import { makeVase } from './splats/vase.ts';

/** WebCodecs requires a secure origin. No request reaches this address. */
const ADDRESS = 'https://film.invalid/';

/** Paths of the robot model. Projects are self-contained folders, so each has its own copy. */
const ROBOT_PATHS = [
  'examples/first-light/assets/robot.glb',
  'examples/templates/occlusion/assets/robot.glb',
  `examples/${LAMP_AND_WINDOW}/assets/robot.glb`,
  `examples/${ROBOT_AND_DESK}/assets/robot.glb`,
  ...foldersWith('robot-tin1').map((folder) => `${folder}/assets/robot.glb`),
];

const PINWHEEL_PATHS = ['nodes/source/model/example/assets/pinwheel.glb'];

const VASE_PATHS = ['nodes/source/splats/example/assets/vase.sog'];

const SKY_PATHS = [
  'nodes/source/panorama/example/assets/sky.hdr',
  'nodes/light/environment/example/assets/sky.hdr',
  `examples/boards/gallery/assets/${GALLERY_FILES.sky}`,
];
const LIT_ROOM_PATHS = ['nodes/light/from-panorama/example/assets/room.hdr', `examples/${LAMP_AND_WINDOW}/assets/room.hdr`];
/** Photos of the same room and their exposures in stops. */
const SHOTS = { bright: 0, middle: -3.5, dark: -7 } as const;
const CAPTURE_FOLDER = 'nodes/source/capture/example/assets/glossy-ball.capture';
const SMALL_CAPTURE_FOLDER = 'nodes/source/capture-mesh/example/assets/glossy-ball.capture';
const CHIME_PATHS = ['nodes/source/audio-file/example/assets/chime.wav'];
const BALL_PATHS = ['nodes/source/video-file/example/assets/film.webm'];
const STRIPES_PATHS = [`examples/boards/gallery/assets/${GALLERY_FILES.film}`];

/** Generates the files of the examples. */
export const main: ToolMain = async ([only], { root }) => {
  // `npm run make-examples -- play` makes the examples to play with alone, `-- paper` those after figures, `-- projects` these without their files.
  if (only === 'play') {
    await placePlay(root);
    return 0;
  }
  if (only === 'projects') {
    for (const recipe of RECIPES) await placeProject(root, recipe.folder, makeProject(library(), recipe));
    return 0;
  }
  if (only === 'book') {
    await placeBook(root);
    return 0;
  }
  if (only === 'paper') {
    await placePaper(root);
    return 0;
  }
  if (only === 'capture') {
    await placeCapture(root);
    return 0;
  }
  if (only === 'desk') {
    await placeDesk(root);
    return 0;
  }
  if (only === 'splats') {
    await place(root, VASE_PATHS, await makeVase());
    return 0;
  }
  await place(root, ROBOT_PATHS, await makeRobot());
  await placeCapture(root);
  await placeDesk(root);
  await placeProject(root, 'boards/gallery', makeGallery(library()));
  await placePlay(root);
  await placeProject(root, LAMP_AND_WINDOW, makeLampAndWindow(library()));
  await placePaper(root);
  await place(root, PINWHEEL_PATHS, await makePinwheel());
  await place(root, VASE_PATHS, await makeVase());
  await place(root, SKY_PATHS, makeSky());
  await place(root, LIT_ROOM_PATHS, makeLitRoom());
  for (const [name, stops] of Object.entries(SHOTS)) {
    await place(root, [`nodes/source/panorama-exposures/example/assets/${name}.png`], makeLitRoomShot(stops));
  }
  await place(root, CHIME_PATHS, makeChime());
  await place(root, BALL_PATHS, await makeFilm(root, 'makeBall'));
  await place(root, STRIPES_PATHS, await makeFilm(root, 'makeStripes'));
  return 0;
};

/** Generates the examples after figures of the paper, and their files but the robot. */
async function placePaper(root: string): Promise<void> {
  for (const recipe of RECIPES) await placeProject(root, recipe.folder, makeProject(library(), recipe));
  const inAll = (asset: string, name: string) => foldersWith(asset).map((folder) => `${folder}/assets/${name}`);
  await place(root, inAll('hands-up04', 'hands.png'), makeHands());
  await placeBook(root);
  for (const [name, bytes] of Object.entries(await makeBracket(root))) await place(root, inAll(`shot-${name}`, `${name}.jpg`), bytes);
  await place(root, inAll('elephant-02', 'elephant.glb'), await makeElephant());
}

/** Writes the models of the book and of the world in it. */
async function placeBook(root: string): Promise<void> {
  const assets = 'examples/the-world-in-the-book/assets';
  await place(root, [`${assets}/pages.glb`], await makePages());
  await place(root, [`${assets}/panes.glb`], await makePanes());
  await place(root, [`${assets}/lectern.glb`], await makeLectern());
  await place(root, [`${assets}/valley.glb`], await makeValley());
  await place(root, [`${assets}/night.glb`], await makeNight());
}

/** Writes the captures of the examples of two nodes. */
async function placeCapture(root: string): Promise<void> {
  const captures = { [CAPTURE_FOLDER]: await makeGlossyBall(), [SMALL_CAPTURE_FOLDER]: await makeGlossyBall(4, 24) };
  for (const [folder, files] of Object.entries(captures))
    for (const [path, bytes] of Object.entries(files)) await place(root, [`${folder}/${path}`], bytes);
}

/** Writes the example with the photographed desk, and its capture. */
async function placeDesk(root: string): Promise<void> {
  await placeProject(root, ROBOT_AND_DESK, makeRobotAndDesk(library()));
  const capture = `examples/${ROBOT_AND_DESK}/assets/desk.capture`;
  for (const [path, bytes] of Object.entries(await photographDesk(root, library()))) await place(root, [`${capture}/${path}`], bytes);
}

/** Generates the physics examples and their models. */
async function placePlay(root: string): Promise<void> {
  for (const recipe of PLAY) await placeProject(root, recipe.folder, makeProject(library(), recipe));
  const run = 'examples/marble-run/assets';
  await place(root, [`${run}/base.glb`], await makeBase());
  await place(root, [`${run}/stand.glb`], await makeStand());
  await place(root, [`${run}/chutes.glb`], await makeChutes());
  for (const [name, colors] of Object.entries(MARBLES)) await place(root, [`${run}/${name}.glb`], await makeMarble(colors));
  const cans = 'examples/tin-cans/assets';
  await place(root, [`${cans}/crate.glb`], await makeCrate());
  await place(root, [`${cans}/can.glb`], await makeCan());
  await place(root, [`${cans}/ball.glb`], await makeBall());
}

/** Folders of the examples whose recipes use the asset. */
function foldersWith(asset: string): string[] {
  return RECIPES.filter(({ assets = {} }) => asset in assets).map(({ folder }) => `examples/${folder}`);
}

function library(): NodeLibrary {
  const byType = new Map<string, NodeDefinition>(DEFINITIONS.map((definition) => [definition.type, definition]));
  return {
    definition: (type) => byType.get(type),
    shader: (name) => SHADERS[name],
    types: () => byType.keys(),
  };
}

async function placeProject(root: string, folder: string, made: Project): Promise<void> {
  const { project, layout } = saveProject(made);
  const text = new TextEncoder();
  await place(root, [`examples/${folder}/project.scrim.json`], text.encode(project));
  await place(root, [`examples/${folder}/project.layout.json`], text.encode(layout));
}

async function place(root: string, paths: readonly string[], bytes: Uint8Array): Promise<void> {
  for (const path of paths) {
    await mkdir(dirname(join(root, path)), { recursive: true });
    await writeFile(join(root, path), bytes);
    console.log(`${path}: ${bytes.length} bytes`);
  }
}

/** Encodes an example video in the pinned browser, which always produces the same bytes. */
async function makeFilm(root: string, film: 'makeBall' | 'makeStripes'): Promise<Uint8Array> {
  const found = await findChromium({ pinnedOnly: true });
  if (!found) throw new Error('The pinned Chromium is missing: run `npm ci` on Linux x64.');
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage();
    await page.route(ADDRESS, (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>film</title>' }));
    await page.goto(ADDRESS);
    await page.addScriptTag({ content: await bundleScript(root, 'tools/examples/film.page.ts', 'film') });
    const bytes = await page.evaluate(`film.${film}()`);
    return Uint8Array.from(bytes as number[]);
  } finally {
    await browser.close();
  }
}
