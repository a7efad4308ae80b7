import { describe, expect, test } from '@jest/globals';
import type { CaptureDocument } from '../../../nodes/kit/capture.ts';
import { pageGpuBytes, phoneReductions, reducedPlaces } from './page-memory.ts';
import type { Place } from './phone-shares.ts';
import type { PreparedAsset, ReportedAsset } from './prepared-asset.ts';

const DEPTH_MESH = { file: '0.bin', widthPx: 1600, heightPx: 1200, vertexCount: 15_000, triangleCount: 30_000 };
const VIEW = { widthPx: 1600, heightPx: 1200, fxPx: 1400, fyPx: 1400, cxPx: 800, cyPx: 600, worldFromCamera: [], depthMesh: DEPTH_MESH };
const ROOM: CaptureDocument = {
  format: 'scrim-capture',
  version: 2,
  mesh: { file: 'mesh.bin', vertexCount: 300_000, triangleCount: 600_000 },
  coarseMesh: { file: 'coarse.bin', vertexCount: 1500, triangleCount: 3000 },
  views: Array.from({ length: 40 }, (_, i) => ({ ...VIEW, file: `${i}.avif` })),
};
const room: Place = {
  asset: { id: 'room', kind: 'capture', path: 'assets/room.capture/capture.json', depthMeshes: true },
  capture: ROOM,
};
const garden: Place = {
  asset: { id: 'garden', kind: 'splats', path: 'assets/garden.ply' },
  capture: null,
  splats: { count: 2_000_000, degree: 3 },
};

describe('what phones show less of a place', () => {
  test('nothing, if it has enough memory', () => {
    expect(phoneReductions(room, 900e6)).toEqual([]);
    expect(phoneReductions(garden, 200e6)).toEqual([]);
  });

  test('is said of a capture: photographs, depth meshes, mesh', () => {
    const smaller = expect.stringMatching(/^has photographs of \d+ × \d+ pixels instead of 915 × 686$/);
    expect(phoneReductions(room, 128e6)).toEqual([smaller]);
    expect(phoneReductions(room, 64e6)).toEqual([smaller, 'is drawn as a lumigraph instead of by its depth meshes']);
    expect(phoneReductions(room, 40e6)).toContain('has a mesh of 3000 triangles instead of 600000');
  });

  test('is said of splats: harmonics, then splats', () => {
    expect(phoneReductions(garden, 128e6)).toEqual(['has harmonics of degree 1 instead of harmonics of degree 3']);
    expect(phoneReductions(garden, 60e6)).toEqual([
      'has colors that do not change with the direction instead of harmonics of degree 3',
      'has its 1666048 most important splats instead of 2000000',
    ]);
  });
});

describe('the memory of a page', () => {
  const report = (
    path: string,
    kind: ReportedAsset['kind'],
    after: number,
    onPhones?: number,
    reducedOnPhones?: string[],
  ): ReportedAsset => ({
    source: `assets/${path}`,
    path,
    kind,
    form: 'original',
    fileBytes: { before: 1, after: 1 },
    gpuBytes: { before: after, after, ...(onPhones === undefined ? {} : { onPhones }) },
    ...(reducedOnPhones ? { reducedOnPhones } : {}),
  });
  const reports = [
    report('robot.glb', 'model', 10e6),
    report('room.json', 'capture', 150e6, 64e6, ['has photographs of 800 × 600 pixels instead of 1600 × 1200', 'has a coarse mesh']),
    report('garden.splats', 'splats', 50e6, 50e6),
    // A second asset of the same file.
    report('garden.splats', 'splats', 50e6, 50e6),
  ];

  test('is the sum of its files, on computers and on phones', () => {
    const places = { onComputers: 200e6, onPhones: 114e6, phoneLimit: 128e6 };
    expect(pageGpuBytes(reports)).toEqual({ assets: 210e6, onPhones: 124e6, places });
    expect(pageGpuBytes(reports.slice(0, 1))).toEqual({ assets: 10e6, onPhones: 10e6, places: null });
  });

  test('is a reason for each place that is reduced, with what to do', () => {
    const assets = reports.map((one) => ({ asset: { path: one.source }, report: one }) as unknown as PreparedAsset);
    expect(reducedPlaces(assets)).toEqual([
      {
        code: 'SCR034',
        severity: 'info',
        message:
          'On phones and headsets, assets/room.json has photographs of 800 × 600 pixels instead of 1600 × 1200, and has a coarse mesh: the captures and splats of a page take at most 128 MB of graphics memory together, and those of this page take 200 MB elsewhere.',
        file: 'assets/room.json',
        fix: expect.stringContaining('fewer or smaller photographs'),
      },
    ]);
    expect(reducedPlaces(assets.slice(2))).toEqual([]);
  });
});
