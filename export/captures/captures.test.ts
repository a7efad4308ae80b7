import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { describeWithColmap, runPython } from '../../tests/support/python.ts';
import { describeWithData } from '../../tests/support/shared-data.ts';
import { readColmapBinary, readColmapText } from './colmap.ts';
import { lensOf, project, unproject } from './lens.ts';
import { readObj } from './mesh-obj.ts';
import { readPly } from './mesh-ply.ts';
import { reprojectionErrorPx } from './source-view.ts';
import { readTransforms } from './transforms-json.ts';
import { pinholeFor, resample } from './undistort.ts';
import { upAxis, uprightPose } from './upright.ts';

const bytes = (text: string) => new TextEncoder().encode(text);
/** A file of 600 MB, of which only the beginning is not zero. */
const large = (text: string) => {
  const file = new Uint8Array(6e8);
  file.set(bytes(text));
  return file;
};
const FOCUS = [533.13454, 533.26009, 342.81079, 234.4391];

/** Columns and rows by OpenCV 5.0.0 (`projectPoints`, `fisheye.projectPoints`) of the directions (0.3, -0.2) and (-0.45, 0.35). */
const OPENCV: readonly (readonly [model: string, distortion: readonly number[], places: readonly (readonly number[])[]])[] = [
  [
    'OPENCV',
    [-0.28996178, 0.10147661, 0.0011039335, -0.00013588031],
    [
      [496.903403, 131.756749],
      [122.699088, 405.850413],
    ],
  ],
  [
    'OPENCV',
    [-0.2, 0.05, 0, 0],
    [
      [498.727852, 130.469914],
      [117.227405, 409.934162],
    ],
  ],
  [
    'FULL_OPENCV',
    [-0.28, 0.1, 0.0011, -0.0013, 0.02, 0.05, -0.03, 0.004],
    [
      [496.0003, 132.304885],
      [124.222949, 404.507307],
    ],
  ],
  [
    'OPENCV_FISHEYE',
    [0.05, -0.01, 0.003, -0.0005],
    [
      [497.213252, 131.479885],
      [121.981846, 406.235393],
    ],
  ],
];

test.each(OPENCV)('projects by %s as OpenCV does, and back', (model, distortion, places) => {
  const lens = lensOf(model, 640, 480, [...FOCUS, ...distortion]);
  const out = new Float64Array(2);
  for (const [i, [x, y]] of (
    [
      [0.3, -0.2],
      [-0.45, 0.35],
    ] as const
  ).entries()) {
    project(lens, x, y, out);
    expect(out[0]).toBeCloseTo(places[i]?.[0] ?? 0, 4);
    expect(out[1]).toBeCloseTo(places[i]?.[1] ?? 0, 4);
    unproject(lens, out[0] ?? 0, out[1] ?? 0, out);
    expect([...out]).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
  }
});

test('a straightened photograph shows each direction where its pinhole camera says', () => {
  const lens = lensOf('OPENCV', 64, 48, [53, 53, 34, 23, -0.29, 0.1, 0.001, 0]);
  const photo = { widthPx: 64, heightPx: 48, data: new Uint8Array(64 * 48 * 4) };
  // Red is the column, green the row.
  for (let i = 0; i < 64 * 48; i++) photo.data.set([4 * (i % 64) + 2, 4 * Math.floor(i / 64) + 2, 0, 255], 4 * i);
  const pinhole = pinholeFor(lens, 1600);
  const straight = resample(photo, lens, pinhole);
  const place = new Float64Array(2);
  for (const [column, row] of [
    [0, 0],
    [63, 47],
    [20, 30],
  ] as const) {
    project(lens, (column + 0.5 - pinhole.cxPx) / pinhole.fxPx, (row + 0.5 - pinhole.cyPx) / pinhole.fyPx, place);
    const at = (row * 64 + column) * 4;
    expect(Math.abs((straight.data[at] ?? 0) - 4 * (place[0] ?? 0))).toBeLessThan(2.5);
    expect(Math.abs((straight.data[at + 1] ?? 0) - 4 * (place[1] ?? 0))).toBeLessThan(2.5);
    // No pixel lies outside the photograph.
    expect([place[0], place[1], 64 - (place[0] ?? 0), 48 - (place[1] ?? 0)].every((x) => (x ?? -1) > -0.01)).toBe(true);
  }
});

describe('meshes', () => {
  const CORNERS = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  test('PLY and OBJ squares become two triangles', () => {
    const head =
      'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n';
    const ply = readPly(bytes(`${head}0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n`));
    const obj = readObj(bytes('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1 2/2 -2/3 4/4\n'));
    for (const { positions, indices } of [ply, obj]) {
      expect([...positions]).toEqual(CORNERS);
      expect([...indices]).toEqual([0, 1, 2, 0, 2, 3]);
    }
  });

  test.each(['binary_little_endian', 'ascii'])('a PLY file of ten million triangles, %s, is refused by its header', (format) => {
    const head = `ply\nformat ${format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 10000000\nproperty list uchar int vertex_indices\nend_header\n`;
    expect(() => readPly(large(head))).toThrow('more than 4000000 triangles');
  });

  test('files of text that are larger than a string can be are read line by line', () => {
    const face = (corner: string) =>
      `ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1\n${corner}\n`;
    expect(() => readObj(large('v 0 0 0\r\n\nf x 1 1\n'))).toThrow('line 3 of the mesh is not a face');
    expect(() => readPly(large(face('nan')))).toThrow('damaged');
    expect(() => readPly(large(face('2')))).toThrow('beyond the 0');
    const cameras = large('1 FOV 4 4 1 1 2 2 0\n');
    expect(() => readColmapText({ cameras, images: bytes(''), points: null })).toThrow('FOV is not supported');
    // Words that lie on the border between two parts of the file.
    const many = readObj(bytes(`${'v 1 2 3\n'.repeat(1_100_000)}f 1 2 -1\n`));
    expect([many.positions.length, [...many.indices]]).toEqual([3_300_000, [0, 1, 1_099_999]]);
    expect(many.positions.every((x, i) => x === (i % 3) + 1)).toBe(true);
  });

  test.each([
    ['v 0 0 0\nv 1 0 0\nv 1 1 nan\nf 1 2 3', 'not finite'],
    ['v 0 0 0\nv 1 0 0\nf 1 2 3', 'beyond the 2'],
    ['v 0 0 0', 'only points'],
  ])('refuses %j', (text, reason) => expect(() => readObj(bytes(text))).toThrow(reason));
});

describe('transforms.json', () => {
  const frame = (rows: readonly (readonly number[])[]) =>
    bytes(JSON.stringify({ camera_angle_x: Math.PI / 2, frames: [{ file_path: './images/a', transform_matrix: rows }] }));
  test('reads poses row by row, and a field of view', () => {
    const { views } = readTransforms(
      frame([
        [0, -1, 0, 5],
        [1, 0, 0, 6],
        [0, 0, 1, 7],
        [0, 0, 0, 1],
      ]),
    );
    expect(views[0]?.worldFromCamera).toEqual([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]);
    // tan 45° is half of the width over the focal length.
    expect(views[0]?.lens(640, 480).fxPx).toBeCloseTo(320, 9);
  });

  test.each([
    [
      [
        [2, 0, 0, 0],
        [0, 2, 0, 0],
        [0, 0, 2, 0],
      ],
      'not rigid',
    ],
    [
      [
        [-1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
      ],
      'mirrored',
    ],
    [
      [
        [1, 0, 0, 'x'],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
      ],
      'not finite',
    ],
  ])('refuses %j', (rows, reason) => expect(() => readTransforms(frame(rows as never))).toThrow(reason));
});

test('turns the up axis of the cameras to y', () => {
  // Y of this camera points along −z of the reconstruction.
  const pose = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 1, 2, 3, 1];
  expect(upAxis([pose])).toBe('-z');
  expect(uprightPose(pose, '-z', 2).map((x) => x + 0)).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, -6, 4, 1]);
});

test('a rig of two cameras has the poses that COLMAP 4.2.1 writes: 12 cm apart, in frames a quarter turn apart', () => {
  const half = Math.SQRT1_2;
  const pose = (turned: boolean, x: number) => `${turned ? `${half} 0 ${half} 0` : '1 0 0 0'} ${x} 0 1`;
  const images = [false, true].flatMap((turned, frame) =>
    [0, -0.12].map((x, i) => `${frame * 2 + i + 1} ${pose(turned, x)} ${i + 1} rig1/camera${i + 1}/image000${frame + 1}.jpg\n\n`),
  );
  const cameras = '1 PINHOLE 64 48 50 50 32 24\n2 PINHOLE 64 48 50 50 32 24\n';
  const { views } = readColmapText({ cameras: bytes(cameras), images: bytes(images.join('')), points: null });
  expect(views.map(({ name }) => name)).toContain('rig1/camera2/image0002.jpg');
  // `Image.projection_center()` of pycolmap.
  const centers = [
    [0, 0, -1],
    [0.12, 0, -1],
    [1, 0, 0],
    [1, 0, 0.12],
  ];
  expect(views.map(({ worldFromCamera }) => worldFromCamera.slice(12, 15))).toEqual(
    centers.map((center) => center.map((x) => expect.closeTo(x, 6))),
  );
});

test('names what a file of COLMAP lacks', () => {
  const listed = bytes('1 1 0 0 0 0 0 0 1 a.jpg\n2 1 0 0 0 0 0 0 1 b.jpg\n');
  expect(() => readColmapText({ cameras: bytes('1 PINHOLE 4 4 1 1 2 2'), images: listed, points: null })).toThrow(
    'line 2 of images.txt does not have the points of a.jpg',
  );
  const images = bytes('1 1 0 0 0 0 0 0 7 a b.jpg\n\n');
  expect(() => readColmapText({ cameras: bytes('1 PINHOLE 4 4 1 1 2 2'), images, points: null })).toThrow('a b.jpg has the camera 7');
  expect(() => readColmapText({ cameras: bytes('1 FOV 4 4 1 1 2 2 0'), images, points: null })).toThrow('FOV is not supported');
  expect(() => readColmapText({ cameras: bytes('1 PINHOLE 4 4 1 NaN 2 2'), images, points: null })).toThrow('line 1 of cameras.txt');
  expect(() => readColmapBinary({ cameras: new Uint8Array([9, 0, 0, 0, 0, 0, 0, 0]), images, points: null })).toThrow(
    'cameras.bin is incomplete',
  );
});

/** Writes a reconstruction of two rigs of two cameras, and prints the camera positions. The places of its points are COLMAP's projections. */
const WRITE_MODEL = `
import json, os, sys, pycolmap
folder, model, params = sys.argv[1], sys.argv[2], json.loads(sys.argv[3])
pycolmap.set_random_seed(1)
options = pycolmap.SyntheticDatasetOptions(num_rigs=2, num_cameras_per_rig=2, num_frames_per_rig=3, num_points3D=200)
options.camera_width, options.camera_height = 1024, 768
options.camera_model_id, options.camera_params = getattr(pycolmap.CameraModelId, model), params
reconstruction = pycolmap.synthesize_dataset(options)
for form in ("text", "binary"):
    os.makedirs(f"{folder}/{form}", exist_ok=True)
    getattr(reconstruction, f"write_{form}")(f"{folder}/{form}")
print(json.dumps({image.name: image.projection_center().tolist() for image in reconstruction.images.values()}))
`;

describeWithColmap('a reconstruction that COLMAP writes', () => {
  let folder = '';
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'scrim-colmap-'));
  });
  afterAll(() => rmSync(folder, { recursive: true }));
  const write = (model: string, params: readonly number[]) => {
    const centers = JSON.parse(runPython(WRITE_MODEL, folder, model, JSON.stringify(params))) as Record<string, readonly number[]>;
    const read = (form: string, ending: string) => {
      const [cameras, images, points] = ['cameras', 'images', 'points3D'].map((name) =>
        readFileSync(join(folder, form, `${name}.${ending}`)),
      );
      if (!cameras || !images) throw new Error('COLMAP wrote no model.');
      return (ending === 'bin' ? readColmapBinary : readColmapText)({ cameras, images, points: points ?? null });
    };
    return { centers, text: () => read('text', 'txt'), binary: () => read('binary', 'bin') };
  };

  test.each([
    ['SIMPLE_PINHOLE', [900, 510, 380]],
    ['PINHOLE', [900, 910, 510, 380]],
    ['SIMPLE_RADIAL', [900, 510, 380, -0.2]],
    ['RADIAL', [900, 510, 380, -0.2, 0.06]],
    ['OPENCV', [900, 910, 510, 380, -0.2, 0.06, 0.002, -0.003]],
    ['OPENCV_FISHEYE', [600, 610, 510, 380, 0.05, -0.01, 0.003, -0.001]],
    ['FULL_OPENCV', [900, 910, 510, 380, -0.2, 0.06, 0.002, -0.003, 0.01, 0.03, -0.02, 0.004]],
  ])('of cameras %s has the poses and places of points that COLMAP computes', (model, params) => {
    const { centers, text, binary } = write(model, params);
    for (const capture of [text(), binary()]) {
      expect(capture.views.map(({ name }) => name).sort()).toEqual(Object.keys(centers).sort());
      expect(capture.views).toHaveLength(12);
      expect(capture.pointCount).toBeGreaterThan(100);
      for (const view of capture.views) {
        const center = centers[view.name] ?? [];
        view.worldFromCamera.slice(12, 15).forEach((x, axis) => {
          expect(x).toBeCloseTo(center[axis] ?? Number.NaN, 9);
        });
        expect(view.observations.length / 5).toBeGreaterThan(50);
        expect(reprojectionErrorPx(view, view.lens(1024, 768))).toBeLessThan(1e-6);
      }
    }
  });

  test.each([
    ['FOV', [900, 910, 510, 380, 0.5]],
    ['SIMPLE_DIVISION', [900, 510, 380, -0.1]],
    ['EUCM', [900, 910, 510, 380, 0.6, 1.1]],
  ])('of cameras %s is refused by name', (model, params) => {
    const { text, binary } = write(model, params);
    expect(text).toThrow(`the camera model ${model} is not supported`);
    expect(binary).toThrow(`the camera model ${model} is not supported`);
  });
});

describeWithData('real reconstructions', 'captures', (folder) => {
  const files = (path: string, ending: string) => {
    const read = (name: string) => new Uint8Array(readFileSync(join(folder, path, `${name}.${ending}`)));
    return { cameras: read('cameras'), images: read('images'), points: read('points3D') };
  };
  test('text and binary files of COLMAP say the same', () => {
    const text = readColmapText(files('icl-livingroom/sparse', 'txt'));
    const binary = readColmapBinary(files('icl-livingroom/sparse_bin', 'bin'));
    expect(text.views).toHaveLength(18);
    expect(binary.pointCount).toBe(text.pointCount);
    for (const [i, view] of text.views.entries()) {
      const other = binary.views[i];
      expect(other?.name).toBe(view.name);
      expect(other?.observations.length).toBe(view.observations.length);
      expect(other?.worldFromCamera).toEqual(view.worldFromCamera.map((x) => expect.closeTo(x, 6)));
    }
  });

  test('a lens of OPENCV reprojects the chessboard within the error that its calibration states', () => {
    const { views } = readColmapText(files('chessboard/sparse', 'txt'));
    const errors = views.map((view) => reprojectionErrorPx(view, view.lens(640, 480)) ?? Number.NaN);
    expect(errors.reduce((sum, error) => sum + error, 0) / errors.length).toBeCloseTo(0.16, 2);
  });
});
