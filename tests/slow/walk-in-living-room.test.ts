import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { Vector3 } from 'three';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { importCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { UNKNOWN_SIZE } from '../../app/services/measure-capture.ts';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, type RgbaImage } from '../support/image.ts';
import { type ProjectText, projectText, writeProject } from '../support/project-kit.ts';
import { serveProject } from '../support/project-page.ts';
import { describeWithData } from '../support/shared-data.ts';
import { judge, TrueView, type Walk, walkPast } from './walk-behind.ts';

const chromium = useBrowser();

/** From behind the chair, after two seconds, to the floor before it half a second later: a frame advances the clock by no more. */
const [BEHIND, BEFORE] = [new Vector3(0.1, -0.41, -1.95), new Vector3(-0.05, -0.41, -1.25)];
const SCALE = 1;
const SUN = { azimuthRad: -1.9, elevationRad: 0.75 } as const;
const POSITION = `[${(['x', 'y', 'z'] as const).map((axis) => `${BEHIND[axis]} + ${BEFORE[axis] - BEHIND[axis]} * 2 * (time - 2)`).join(', ')}]`;

const NODES: ProjectText['nodes'] = {
  'place-a1': ['source/capture', { file: 'room' }],
  'mesh-a1': ['source/capture-mesh', { file: 'room' }],
  'robot-a1': ['source/model', { model: 'robot' }],
  'walk-a1': ['objects/transform', { scale: SCALE, positionM: { expression: POSITION }, rotationRad: [0, -0.35, 0] }],
  'sun-a1': ['light/directional', SUN],
  'scene-a1': 'layer/scene',
  'shadow-a1': 'layer/shadow',
  'under-a1': 'operator/over',
  'over-a1': 'operator/over',
  'screen-a1': 'output/screen',
};
const WIRES = [
  ...['robot-a1.objects -> walk-a1.objects', 'walk-a1.objects -> scene-a1.objects', 'mesh-a1.objects -> scene-a1.objects'],
  ...['sun-a1.lights -> scene-a1.lights', 'sun-a1.lights -> shadow-a1.lights', 'walk-a1.objects -> shadow-a1.casters'],
  ...['mesh-a1.objects -> shadow-a1.receivers', 'shadow-a1.layer -> under-a1.top', 'place-a1.layer -> under-a1.bottom'],
  ...['under-a1.layer -> over-a1.bottom', 'scene-a1.layer -> over-a1.top', 'over-a1.layer -> screen-a1.layer'],
];
const without = (...left: readonly string[]) => WIRES.filter((wire) => !left.includes(wire));
const VARIANTS = {
  whole: WIRES,
  robot: [...without('mesh-a1.objects -> scene-a1.objects', 'over-a1.layer -> screen-a1.layer'), 'scene-a1.layer -> screen-a1.layer'],
  shadow: without('walk-a1.objects -> scene-a1.objects'),
  place: [...without('over-a1.layer -> screen-a1.layer'), 'place-a1.layer -> screen-a1.layer'],
} as const;

describeWithData('a captured living room', 'captures/icl-livingroom', (folder) => {
  test('hides a robot that walks behind its chair and receives its shadow, for both eyes of a headset', async () => {
    const { buffer, byteOffset, byteLength } = await readFile(join(folder, 'mesh.ply'));
    // Its y axis points down.
    const mesh = new PLYLoader().parse(buffer.slice(byteOffset, byteOffset + byteLength) as ArrayBuffer).rotateX(Math.PI);
    const walk: Walk = {
      head: { position: [0.2, 0.35, -0.05], pitchRad: -0.33 },
      fovYRad: 0.9,
      framesPerSecond: 2,
      footAt: (timeS) => BEHIND.clone().lerp(BEFORE, 2 * (timeS - 2)),
      scale: SCALE,
      sun: SUN,
      surfaces: [mesh],
    };
    const base = await mkdtemp(join(tmpdir(), 'scrim-living-room-'));
    await cp(resolve('examples/first-light/assets/robot.glb'), join(base, 'assets/robot.glb'));
    await writeProject(base, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
    const { path, views } = await importCapture({
      ...{ folder, root: base, sources: resolve('.'), name: 'room', maxSidePx: 320, up: null, metersPerUnit: 1, known: UNKNOWN_SIZE },
      depth: { from: 'none', unit: null, kind: null },
      files: NODE_FILES,
      say: () => {},
      interrupted: new AbortController().signal,
    });
    const assets = { room: { path, kind: 'capture' }, robot: { path: 'assets/robot.glb', kind: 'model' } } as const;
    const visit = async (variant: keyof typeof VARIANTS, frames: number) => {
      await writeProject(base, { 'project.scrim.json': projectText({ nodes: NODES, wires: VARIANTS[variant], assets }) });
      const served = await serveProject(base);
      const { eyes, seen, errors } = await walkPast(chromium.browser, served.url, walk, frames, variant === 'robot' ? 0 : views.length);
      await served.close();
      expect(errors).toEqual([]);
      expect(eyes).toHaveLength(2);
      if (process.env.SCRIM_PICTURES) {
        for (const [i, { layer }] of seen.entries())
          await writeFile(join(process.env.SCRIM_PICTURES, `room-${variant}-${i}.png`), encodeImage(layer));
      }
      return { eyes, seen };
    };
    const { eyes, seen } = await visit('whole', 2);
    const [robot, shadow] = [await visit('robot', 2), await visit('shadow', 2)];
    // It does not change.
    const place = (await visit('place', 1)).seen[0]?.layer as RgbaImage;
    await rm(base, { recursive: true });
    const view = new TrueView(walk);
    for (const eye of eyes) {
      const [behind, before] = seen.map(({ timeS, layer: whole }, i) => {
        const [robotImage, shadowImage] = [robot, shadow].map((variant) => variant.seen[i]?.layer as RgbaImage) as [RgbaImage, RgbaImage];
        return judge(view, eye, walk.footAt(timeS), { whole, robot: robotImage, shadow: shadowImage, place });
      });
      if (!behind || !before) throw new Error('There are not two images.');
      if (process.env.SCRIM_PICTURES) console.log(behind, before);
      expect(behind.hidden).toBeGreaterThan(30);
      expect(before.visible).toBeGreaterThan(300);
      for (const shot of [behind, before]) {
        expect(shot.hiddenWrong + shot.visibleWrong).toBeLessThan(0.02 * (shot.hidden + shot.visible));
        expect(shot.light).toBeGreaterThan(3000);
        expect(shot.lightWrong).toBeLessThan(0.005 * shot.light);
      }
      expect(before.dark).toBeGreaterThan(20);
      expect(before.darkWrong).toBeLessThan(0.05 * before.dark);
      expect(before.darkenedAwayM).toBeGreaterThan(0.05);
    }
  });
});
