import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { roomBox } from '../xr/room-box.ts';
import { openXrPage, readCapture } from '../xr/xr-page.ts';
import { eyesOf, findPoses, HEIGHT, type Place, tally, WIDTH } from './room-rays.ts';

// What `page-rooms.test.ts` shows for a device that measures best, for devices that measure otherwise: depth coarse and turned, or of
// a camera of its own; light guessed from the camera's picture; shadows on planes, on meshes, or on what depth alone shows.

const chromium = useBrowser();
/** Rooms, and where their floor is free around the box. */
const SMALL = { name: 'office_small', place: [-0.4, 0.3] } as const;
/** Its floor is one plane, from wall to wall. */
const MEETING = { name: 'meeting_room', place: [-1, 0.25] } as const;
/** Of pixels that are looked at, so many may be off: scanned floors are bumpy, and their shadow is thin where they slope away. */
const OFF = 0.05;

/** The box, with other params, and its shadow on something else than the phantom floor. */
function project(
  params: Readonly<Record<string, object>>,
  fallsOn: 'floor' | 'planes' | 'meshes' | 'depth' = 'floor',
  place: Place = SMALL.place,
): ProjectText {
  const { nodes, wires, ...rest } = roomBox(...place);
  const withParams = Object.entries(nodes).map(([id, node]) => {
    const [type, own = {}] = typeof node === 'string' ? [node] : node;
    return [id, [type, { ...own, ...params[id] }]] as const;
  });
  const floor = 'real-0000.objects -> shadow-0000.receivers';
  const surfaces = fallsOn === 'planes' || fallsOn === 'meshes';
  return {
    ...rest,
    nodes: { ...Object.fromEntries(withParams), ...(surfaces && { 'found-0000': `world/${fallsOn}` }) },
    wires: [
      ...wires.filter((wire) => fallsOn === 'floor' || wire !== floor),
      ...(surfaces ? ['found-0000.objects -> shadow-0000.receivers'] : []),
      ...(fallsOn === 'depth' ? ['depth-0000.depth -> shadow-0000.depth'] : []),
    ],
  };
}

/** Asks for depth as its camera sees it, as a browser gives it that knows no other. */
const OWN_DEPTH = `{
  const own = navigator.xr.requestSession.bind(navigator.xr);
  navigator.xr.requestSession = (mode, init = {}) =>
    own(mode, init.depthSensing ? { ...init, depthSensing: { ...init.depthSensing, matchDepthView: false } } : init);
}`;

interface Case {
  readonly what: string;
  readonly project: ProjectText;
  readonly options: EmulatorOptions;
  readonly room?: { readonly name: string; readonly place: Place };
  readonly script?: string;
  readonly marginPx?: number;
  /** Shadows fall on furniture too. */
  readonly floorAlone?: true;
}

const BESIDE = { positionM: [0.06, 0.03, 0], fovYRad: 1.35 } as const;

const CASES: readonly Case[] = [
  {
    what: 'by 160 × 90 samples of a turned sensor, in light guessed from the camera picture',
    project: project({ 'light-0000': { guessFromCamera: true } }),
    options: { device: 'phone', refuse: ['light-estimation'], depth: { sizePx: [160, 90], transform: { turnDeg: 180, flipX: true } } },
    marginPx: 6,
  },
  {
    what: 'by 640 × 480 samples of a camera beside the eye, with edges as the camera picture has them',
    project: project({ 'depth-0000': { filter: 'edge-aware' } }),
    options: { device: 'phone', depth: { sizePx: [640, 480], sensor: BESIDE } },
    script: OWN_DEPTH,
    marginPx: 5,
  },
  {
    what: 'by depth on the GPU of cameras beside both eyes, its shadow on meshes',
    project: project({}, 'meshes'),
    options: { device: 'headset', extra: ['light-estimation'], depth: { sizePx: [320, 480], sensor: BESIDE } },
    script: OWN_DEPTH,
    marginPx: 5,
    floorAlone: true,
  },
  {
    what: 'with its shadow on planes that the device found',
    project: project({}, 'planes', MEETING.place),
    room: MEETING,
    options: { device: 'phone', depth: { sizePx: [WIDTH, HEIGHT] } },
    floorAlone: true,
  },
  {
    what: 'with its shadow on what depth alone shows',
    project: project({}, 'depth'),
    options: { device: 'phone', depth: { sizePx: [WIDTH, HEIGHT] } },
    marginPx: 4,
    floorAlone: true,
  },
];

describe.each(CASES)(
  'a box in a scanned room, $what',
  ({ project: text, options, room = SMALL, script = '', marginPx = 2, floorAlone }) => {
    let served: ServedExport;
    beforeAll(async () => {
      served = await serveProjectText(text, {});
    });
    afterAll(() => served?.close());

    test('is hidden and throws its shadow as the rays say', async () => {
      const given: EmulatorOptions = { room: await readCapture(room.name), sizePx: [WIDTH, HEIGHT], display: false, ...options };
      const xr = await openXrPage(chromium.browser, served.url, given, { width: WIDTH, height: HEIGHT }, script);
      await xr.enter();
      const sums: Record<string, number> = {};
      for (const matrix of await findPoses(xr, room.place)) {
        await xr.setPose({ matrix });
        await xr.step(4);
        const layer = await xr.readLayer();
        for (const eye of await eyesOf(xr)) {
          const { counts, wrong } = await tally(xr, room.place, eye, layer, { marginPx, leaveOut: floorAlone ? ['hidden', 'room'] : [] });
          const all = Object.values(counts).reduce((sum, count) => sum + count, 0);
          expect(wrong.length <= OFF * all ? [] : wrong).toEqual([]);
          for (const [kind, count] of Object.entries(counts)) sums[kind] = (sums[kind] ?? 0) + count;
        }
      }
      const kinds = ['box', 'shadow', 'lit floor', ...(floorAlone ? [] : ['hidden'])];
      for (const kind of kinds) expect([kind, (sums[kind] ?? 0) > 2]).toEqual([kind, true]);
      expect(xr.errors).toEqual([]);
      await xr.close();
    });
  },
);
