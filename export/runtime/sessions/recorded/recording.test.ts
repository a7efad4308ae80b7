import { describe, expect, test } from '@jest/globals';
import { emptyVoxels, writeVoxelFile } from '../../../../nodes/kit/voxel-file.ts';
import type { SessionFile } from '../session-format.ts';
import { openRecording } from './recording.ts';

const UPRIGHT = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const LIGHT = {
  sphericalHarmonics: new Array<number>(27).fill(0.25),
  primaryDirectionWorld: [0, 1, 0],
  primaryIntensity: [1, 2, 3],
} as const;

const FLOOR = {
  kind: 'plane',
  orientation: 'horizontal',
  worldFromPlane: UPRIGHT,
  polygonXZ: [
    [-1, -2],
    [1, -2],
    [0, 2],
  ],
} as const;

const FILE: SessionFile = {
  format: 'scrim-session',
  version: 1,
  title: 'A room',
  color: { widthPx: 4, heightPx: 3, intrinsics: { fxPx: 4, fyPx: 4, cxPx: 2, cyPx: 1.5 } },
  depth: { widthPx: 2, heightPx: 2, intrinsics: { fxPx: 2, fyPx: 2, cxPx: 1, cyPx: 1 }, metresPerUnit: 0.001, kind: 'z' },
  frameRateHz: 10,
  frames: [
    { timeS: 5, color: 'color/0.jpg', depth: 'depth/0.png', worldFromCamera: UPRIGHT },
    { timeS: 5.1, color: 'color/1.jpg', worldFromCamera: UPRIGHT, light: { ...LIGHT, primaryIntensity: [9, 9, 9] } },
    { timeS: 5.3, color: 'color/2.jpg', depth: 'depth/2.png', worldFromCamera: UPRIGHT },
  ],
  light: LIGHT,
  surfaces: [{ ...FLOOR, id: 'floor', label: 'floor' }],
};

function open(text: string): ReturnType<typeof openRecording> {
  return openRecording({ load: async () => new TextEncoder().encode(text).buffer });
}

/** The file with one thing changed: a path of keys and a value. */
function changed(path: readonly (string | number)[], value: unknown): string {
  const copy = structuredClone(FILE) as unknown as Record<string | number, unknown>;
  let at = copy;
  for (const key of path.slice(0, -1)) at = at[key] as Record<string | number, unknown>;
  at[path.at(-1) as string] = value;
  return JSON.stringify(copy);
}

describe('the voxels of a recording', () => {
  const openWith = (voxels: Uint8Array | null) =>
    openRecording({
      load: async (path) => {
        if (path !== 'room.voxels') return new TextEncoder().encode(JSON.stringify({ ...FILE, room: 'room.voxels' })).buffer;
        if (!voxels) throw new Error('There is no file room.voxels');
        return Uint8Array.from(voxels).buffer;
      },
    });
  const voxels = writeVoxelFile(emptyVoxels(0.05, 2));

  test('are read with it', async () => {
    const { output, diagnostics } = await openWith(voxels);
    expect([output?.room, diagnostics]).toEqual([voxels, []]);
    expect((await open(JSON.stringify(FILE))).output?.room).toBeNull();
  });

  test.each([
    [
      'truncated',
      voxels.slice(0, 30),
      'The room “room.voxels” cannot be used: It is truncated: it has 30 of 52 bytes. The session plays without it.',
    ],
    [
      'something else',
      Uint8Array.of(1, 2, 3, 4),
      'The room “room.voxels” cannot be used: It is not a voxel file. The session plays without it.',
    ],
    ['missing', null, 'The room “room.voxels” cannot be used: There is no file room.voxels. The session plays without it.'],
  ])('that are %s give a warning, and the session plays without them', async (_, bytes, message) => {
    const { output, diagnostics } = await openWith(bytes);
    expect([output?.room, output?.frames.timesS.length]).toEqual([null, 3]);
    expect(diagnostics).toMatchObject([{ code: 'SCR054', severity: 'warning', message }]);
  });
});

describe('a session folder', () => {
  test('is read with its times, lights and surfaces', async () => {
    const { output, diagnostics } = await open(JSON.stringify(FILE));
    expect(diagnostics).toEqual([]);
    expect(output?.frames).toEqual({ timesS: [0, 0.1, 0.3].map((timeS) => expect.closeTo(timeS, 9)), durationS: expect.closeTo(0.4, 9) });
    expect(output?.lights.map((light) => light?.primaryIntensity[0])).toEqual([1, 9, 1]);
    expect(output?.surfaces?.planes).toMatchObject([{ id: 'floor', label: 'floor', outlineXZ: Float32Array.of(-1, -2, 1, -2, 0, 2) }]);
  });

  test.each<[string, string, string]>([
    ['no JSON', '{"format":', 'not valid JSON'],
    ['another file', '{}', 'not a Scrim session'],
    ['null', 'null', 'not a Scrim session'],
    ['a newer version', changed(['version'], 2), 'Version 2 of the session is not supported'],
    ['no size', changed(['color', 'widthPx'], 0), 'color.widthPx'],
    ['broken intrinsics', changed(['depth', 'intrinsics'], { fxPx: 1 }), 'depth.intrinsics'],
    ['no unit', changed(['depth', 'metresPerUnit'], -1), 'depth.metresPerUnit'],
    ['an unknown kind', changed(['depth', 'kind'], 'disparity'), 'depth.kind'],
    ['no rate', changed(['frameRateHz'], null), 'frameRateHz'],
    ['no frames', changed(['frames'], []), 'at least one frame'],
    ['a frame without a time', changed(['frames', 1, 'timeS'], 'soon'), 'frames[1].timeS'],
    ['time running backwards', changed(['frames', 2, 'timeS'], 5), 'frames[2].timeS'],
    ['a short matrix', changed(['frames', 0, 'worldFromCamera'], [1, 2, 3]), 'frames[0].worldFromCamera'],
    ['a path out of the folder', changed(['frames', 0, 'color'], '../secret.jpg'), 'frames[0].color'],
    ['an absolute path', changed(['frames', 0, 'depth'], '/etc/passwd'), 'frames[0].depth'],
    ['an address', changed(['frames', 0, 'color'], 'https://example.com/a.jpg'), 'frames[0].color'],
    ['a backslash', changed(['frames', 0, 'color'], 'a\\..\\b.jpg'), 'frames[0].color'],
    ['depth that nothing describes', changed(['depth'], undefined), 'frames[0].depth'],
    ['half a light', changed(['light', 'sphericalHarmonics'], [1]), 'light.sphericalHarmonics'],
    ['a surface of two corners', changed(['surfaces', 0, 'polygonXZ'], FLOOR.polygonXZ.slice(0, 2)), 'surfaces[0].polygonXZ'],
    ['a slanting surface', changed(['surfaces', 0, 'orientation'], 'slanting'), 'surfaces[0].orientation'],
    ['surfaces that are called alike', changed(['surfaces', 1], { ...FLOOR, id: 'floor' }), 'surfaces[1].id'],
  ])('with %s is broken, and says where', async (_name, text, place) => {
    const { output, diagnostics } = await open(text);
    expect(output).toBeNull();
    expect(diagnostics[0]).toMatchObject({ code: 'SCR054', severity: 'error', file: 'session.json' });
    expect(diagnostics.map((d) => d.message).join('\n')).toContain(place);
  });

  test('that cannot be read says why', async () => {
    const { output, diagnostics } = await openRecording({ load: () => Promise.reject(new Error('there is no such file')) });
    expect(output).toBeNull();
    expect(diagnostics[0]?.message).toBe('The session folder cannot be read: there is no such file.');
  });
});
