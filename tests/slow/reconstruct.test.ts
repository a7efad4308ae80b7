import { cp, mkdir, mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { runCli } from '../../app/cli/run-cli.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readCaptureFolder } from '../../app/services/read-capture-folder.ts';
import { depthSeen } from '../../export/captures/depth/depth-from-mesh.ts';
import { pinholeFor } from '../../export/captures/undistort.ts';
import { describeWithProgram } from '../support/colmap.ts';
import { scrim } from '../support/scrim.ts';
import { describeWithData } from '../support/shared-data.ts';

const PHOTOS = ['00000.jpg', '00010.jpg', '00020.jpg', '00030.jpg', '00040.jpg', '00050.jpg'];

describeWithProgram('scrim reconstruct', () => {
  describeWithData('of photographs of a room', 'captures/icl-livingroom', (room) => {
    let base = '';
    let folder = '';
    beforeAll(async () => {
      base = await mkdtemp(join(tmpdir(), 'scrim-reconstruct-'));
      folder = join(base, '-my scan');
      await mkdir(join(folder, 'images'), { recursive: true });
      for (const name of PHOTOS) await cp(join(room, 'images', name), join(folder, 'images', name));
    });
    afterAll(() => rm(base, { recursive: true, force: true }));

    const reconstructed = async () => {
      const { status, out, err } = await scrim('reconstruct', folder, '--json');
      expect([status, err]).toEqual([0, '']);
      return JSON.parse(out) as { photographs: number; found: number; mesh: string | null; kept: string[]; log: string };
    };

    test('continues after Ctrl-C, and finds the cameras where they are', async () => {
      const interruption = new AbortController();
      const said: string[] = [];
      const status = await runCli(
        ['reconstruct', folder],
        installationAt(resolve('.'), '1.2.3'),
        {
          out: () => {},
          err: (text) => said.push(text),
          interactive: true,
          progress: (text) => {
            if (text?.includes('Matching photographs')) interruption.abort();
          },
        },
        interruption.signal,
      );
      expect(status).toBe(130);
      expect((await readdir(folder)).sort()).toEqual(['.scrim-reconstruction', 'images']);

      const first = await reconstructed();
      expect([first.photographs, first.found, first.kept]).toEqual([6, 6, ['features']]);
      const log = await readFile(first.log, 'utf8');
      expect(log.match(/"feature_extractor","--database_path"|"feature_extractor" "--database_path"/g)).toHaveLength(1);
      expect(await centerRatios(folder)).toEqual((await centerRatios(room)).map((ratio) => expect.closeTo(ratio, 1)));

      const again = await reconstructed();
      expect([again.found, again.kept]).toEqual([6, ['features', 'matches', 'sparse', 'mesh']]);
    });

    test('makes a mesh of the points, which is where the room is', async () => {
      const [ours, truth] = [await readCaptureFolder(folder), await readCaptureFolder(room)];
      expect(ours.mesh?.indices.length).toBeGreaterThan(3000);
      const centers = (views: typeof ours.views) =>
        PHOTOS.map((name) => views.find(({ view }) => view.name === name)?.view.worldFromCamera.slice(12, 15));
      const length = ([first, second]: ReturnType<typeof centers>) =>
        Math.hypot(...(second ?? []).map((x, axis) => x - (first?.[axis] ?? 0)));
      const scale = length([centers(truth.views)[0], centers(truth.views)[5]]) / length([centers(ours.views)[0], centers(ours.views)[5]]);
      const errors = PHOTOS.flatMap((name) => {
        const viewIn = ({ views }: typeof ours) => views.find(({ view }) => view.name === name);
        const lens = viewIn(truth)?.lens;
        const [a, b] = [ours, truth].map((place) => {
          const pose = viewIn(place)?.view.worldFromCamera;
          if (!place.mesh || !pose || !lens) throw new Error(`${name} has no camera, or the place no mesh.`);
          return depthSeen(place.mesh, pinholeFor(lens, 160), pose).values;
        });
        return [...(b ?? [])].flatMap((m, i) => (m > 0 ? [(a?.[i] ?? 0) > 0 ? Math.abs((scale * (a?.[i] ?? 0)) / m - 1) : 1] : []));
      }).sort((a, b) => a - b);
      // What it does not cover counts as 1.
      if (process.env.SCRIM_FIGURES) console.log('median and 90 %', errors[errors.length >> 1], errors[Math.floor(0.9 * errors.length)]);
      expect(errors[errors.length >> 1]).toBeLessThan(0.1);
    });

    test('does not replace cameras that it did not find', async () => {
      const other = join(base, 'other');
      await cp(join(folder, 'images'), join(other, 'images'), { recursive: true });
      await cp(join(folder, 'sparse'), join(other, 'sparse'), { recursive: true });
      const { status, err } = await scrim('reconstruct', other);
      expect([status, err]).toEqual([1, expect.stringMatching(/SCR061.*sparse exists already/)]);
    });
  });
});

/** The distances between neighbors, relative to that of the first two: a reconstruction has no scale. */
async function centerRatios(folder: string): Promise<readonly number[]> {
  const { views } = await readCaptureFolder(folder);
  const centers = PHOTOS.map((name) => views.find(({ view }) => view.name === name)?.view.worldFromCamera.slice(12, 15) ?? []);
  const distances = centers.slice(1).map((center, i) => Math.hypot(...center.map((x, axis) => x - (centers[i]?.[axis] ?? 0))));
  return distances.map((distance) => distance / (distances[0] ?? 1));
}
