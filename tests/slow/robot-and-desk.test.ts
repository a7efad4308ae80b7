import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { Vector3 } from 'three';
import { deskSurfaces, SUN } from '../../tools/examples/photographed-desk.ts';
import { DESK_AT, ROBOT_AND_DESK, ROBOT_SCALE, WALK } from '../../tools/examples/robot-and-desk.ts';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { serveProject } from '../support/project-page.ts';
import { agreement, centerOfChange, type Findings, HEIGHT, judge, TrueView, type Walk, WIDTH, walkPast } from './walk-behind.ts';

const EXAMPLE = resolve('examples', ROBOT_AND_DESK);
const chromium = useBrowser();

/**
 * The robot hurries, because a frame advances the clock of a page by half a second at most: it is behind the desk in the first image, beside it
 * in the second, and before it in the third.
 */
const RAD_PER_S = 3.34;

const walk: Walk = {
  head: { position: [-0.1, 1.5, 0.1], pitchRad: -0.53 },
  fovYRad: 1.05,
  framesPerSecond: 2,
  footAt: (timeS) => {
    const angle = WALK.startRad + timeS * RAD_PER_S;
    return new Vector3(WALK.xM * Math.sin(angle), 0, WALK.zM * Math.cos(angle)).add(new Vector3(...DESK_AT));
  },
  scale: ROBOT_SCALE,
  sun: SUN,
  surfaces: deskSurfaces().map((surface) => surface.translate(...DESK_AT)),
};

interface Saved {
  readonly graphs: {
    readonly main: {
      readonly nodes: Record<string, { type: string; muted?: boolean; params?: Record<string, unknown> }>;
      wires: string[];
    };
  };
}

/** The example, and what is left out of it or replaced. */
const VARIANTS = {
  example: () => {},
  'black and white': ({ nodes }) =>
    Object.assign(nodeOf(nodes, 'filter/comic-drawing'), { type: 'filter/threshold', params: { level: LEVEL } }),
  whole: ({ nodes }) => {
    nodeOf(nodes, 'filter/comic-drawing').muted = true;
  },
  shadow: (main) => {
    VARIANTS.whole(main);
    main.wires = main.wires.filter((wire) => !/^walk-\w+\.objects -> scene/.test(wire));
  },
  place: (main) => {
    VARIANTS.shadow(main);
    nodeOf(main.nodes, 'layer/shadow').params = { strength: 0 };
  },
  robot: (main) => {
    const scene = Object.keys(main.nodes).find((id) => main.nodes[id]?.type === 'layer/scene');
    main.wires = main.wires
      .filter((wire) => !/^mesh-\w+\.objects -> scene/.test(wire))
      .map((wire) => wire.replace(/^print-\w+\.layer -> screen/, `${scene}.layer -> screen`));
  },
} satisfies Record<string, (main: Saved['graphs']['main']) => unknown>;
const LEVEL = 0.4;

function nodeOf(nodes: Saved['graphs']['main']['nodes'], type: string) {
  const node = Object.values(nodes).find((candidate) => candidate.type === type);
  if (!node) throw new Error(`The example has no ${type}.`);
  return node;
}

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-desk-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

async function visit(variant: keyof typeof VARIANTS, frames: number) {
  const folder = join(base, variant);
  await cp(EXAMPLE, folder, { recursive: true });
  const text = await readFile(join(folder, 'project.scrim.json'), 'utf8');
  const project = JSON.parse(text.replaceAll(`time * ${WALK.radPerS}`, `time * ${RAD_PER_S}`)) as Saved;
  VARIANTS[variant](project.graphs.main);
  await writeFile(join(folder, 'project.scrim.json'), JSON.stringify(project));
  const served = await serveProject(folder);
  const { eyes, seen, errors } = await walkPast(chromium.browser, served.url, walk, frames, variant === 'robot' ? 0 : 16);
  await served.close();
  expect(errors).toEqual([]);
  expect(eyes).toHaveLength(2);
  if (process.env.SCRIM_PICTURES) {
    for (const [i, { layer }] of seen.entries())
      await writeFile(join(process.env.SCRIM_PICTURES, `${variant}-${i}.png`), encodeImage(layer));
  }
  return { eyes, seen };
}

test('a robot walks around a photographed desk, for both eyes of a headset', async () => {
  const view = new TrueView(walk);
  const { eyes, seen } = await visit('whole', 3);
  const robot = await visit('robot', 3);
  const shadow = await visit('shadow', 3);
  // It does not change.
  const place = (await visit('place', 1)).seen[0]?.layer as RgbaImage;
  const shots = seen.map(({ timeS, layer: whole }, i) => {
    const [robotImage, shadowImage] = [robot, shadow].map((variant) => variant.seen[i]?.layer as RgbaImage) as [RgbaImage, RgbaImage];
    return { foot: walk.footAt(timeS), whole, robot: robotImage, shadow: shadowImage, place };
  });
  for (const eye of eyes) {
    const found = shots.map(({ foot, ...images }) => judge(view, eye, foot, images));
    if (process.env.SCRIM_PICTURES) console.log(found);
    const [behind, beside, before] = found as [Findings, Findings, Findings];
    expect(Math.min(behind.hidden, behind.visible)).toBeGreaterThan(40);
    for (const { hidden, visible, ...shot } of [beside, before]) {
      expect([hidden, shot.hiddenWrong]).toEqual([0, 0]);
      expect(visible).toBeGreaterThan(150);
    }
    // Its shadow falls on the top of the desk while it is behind that, and on the floor beside it.
    expect(behind.darkenedOnTop).toBeGreaterThan(30);
    for (const shot of found) {
      expect(shot.hiddenWrong + shot.visibleWrong).toBeLessThan(0.01 * (shot.hidden + shot.visible));
      expect(shot.dark).toBeGreaterThan(12);
      expect(shot.light).toBeGreaterThan(6000);
      expect([shot.darkWrong, shot.lightWrong]).toEqual([0, 0]);
      expect(shot.darkenedAwayM).toBeGreaterThan(0.1);
    }
  }
  // Where nothing hides it, each eye sees it at its own place.
  for (const { foot, whole, shadow: without } of shots.slice(1)) {
    const middle = foot.clone().add(new Vector3(0, 0.21 * ROBOT_SCALE, 0));
    const offsPx = eyes.map((eye) => centerOfChange(eye, whole, without).x - view.project(eye, middle).x);
    if (process.env.SCRIM_PICTURES) console.log(offsPx);
    expect(Math.max(...offsPx.map(Math.abs))).toBeLessThan(4);
    expect(Math.abs((offsPx[0] ?? 0) - (offsPx[1] ?? 0))).toBeLessThan(1);
  }
  // What both eyes see of the desk is one thing at its distance.
  const { count, seen: same, unmoved } = agreement(view, eyes, place);
  if (process.env.SCRIM_PICTURES) console.log({ count, same, unmoved });
  expect(count).toBeGreaterThan(4000);
  expect(same).toBeGreaterThan(0.88);
  expect(unmoved).toBeLessThan(0.6);

  // A filter applies to robot, shadow and place alike.
  const plain = shots[0] as (typeof shots)[number];
  const filtered = (await visit('black and white', 1)).seen[0]?.layer as RgbaImage;
  const tally = { robot: { dark: 0, light: 0 }, place: { dark: 0, light: 0 }, wrong: 0 };
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      const [red, green, blue, alpha] = pixelAt(plain.whole, x, y);
      if (alpha !== 255) continue;
      const luma = (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255 - LEVEL;
      const value = pixelAt(filtered, x, y);
      if (value.some((channel, c) => channel !== (c === 3 || luma > 0 ? 255 : 0)) && Math.abs(luma) > 0.01) tally.wrong++;
      tally[pixelAt(plain.robot, x, y)[3] === 255 ? 'robot' : 'place'][luma > 0 ? 'light' : 'dark']++;
    }
  }
  if (process.env.SCRIM_PICTURES) console.log(tally);
  // Pixels at edges may differ.
  expect(tally.wrong).toBeLessThan(0.001 * (tally.place.dark + tally.place.light));
  expect(Math.min(tally.robot.dark, tally.robot.light)).toBeGreaterThan(100);
  expect(Math.min(tally.place.dark, tally.place.light)).toBeGreaterThan(3000);
  // The page as it is: the comic has ink lines, black where nothing else is.
  const comic = (await visit('example', 1)).seen[0]?.layer as RgbaImage;
  expect(blackIn(comic)).toBeGreaterThan(blackIn(plain.whole) + 100);
});

/** Opaque pixels that are nearly black. */
function blackIn({ data }: RgbaImage): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] === 255 && (data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0) < 45) count++;
  return count;
}
