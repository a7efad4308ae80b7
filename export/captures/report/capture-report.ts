import type { CaptureMesh, CaptureView } from '../../../nodes/kit/capture.ts';
import { sampleSurface } from '../points/sample-surface.ts';
import type { ImportRecord, RecordedView } from './import-record.ts';
import { scaleWords } from './scale-source.ts';

/** What is known of a capture: what its import understood, and its cameras over its mesh. */
export interface CaptureReport {
  /** Null for captures that were imported before Scrim kept it. */
  readonly record: ImportRecord | null;
  /** Photographs with their cameras; without files of depth. */
  readonly views: readonly CaptureView[];
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** Size of the mesh along x, y and z, meters. */
  readonly sizeM: readonly number[];
  /** Points that are spread over the mesh: x, y and z of each, meters. */
  readonly surface: readonly number[];
}

const SURFACE_POINTS = 5000;

/** Reports what is known of a capture. `record` is null if it has none. */
export function reportOfCapture(views: readonly CaptureView[], mesh: CaptureMesh, record: ImportRecord | null): CaptureReport {
  return {
    record,
    views: views.map(({ reducedFile, depth, depthMesh, hiddenMesh, ...camera }) => camera),
    vertexCount: mesh.positions.length / 3,
    triangleCount: mesh.indices.length / 3,
    sizeM: sizeOfMesh(mesh),
    surface: Array.from(sampleSurface(mesh, SURFACE_POINTS), (x) => Math.round(1e4 * x) / 1e4),
  };
}

/** The size of a mesh along x, y and z. */
export function sizeOfMesh({ positions }: CaptureMesh): readonly number[] {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const x = positions[i] ?? 0;
    least[i % 3] = Math.min(least[i % 3] ?? x, x);
    most[i % 3] = Math.max(most[i % 3] ?? x, x);
  }
  return most.map((x, i) => x - (least[i] ?? 0));
}

/** A photograph of a report. */
export interface ReportedPhoto {
  /** Its index in the capture. */
  readonly index: number;
  readonly view: CaptureView;
  /** Null for captures without record. */
  readonly about: RecordedView | null;
  /** Its name before the import, if that is known. */
  readonly name: string;
}

/** The photographs in the order of the capture. */
export function photosOf({ views, record }: Pick<CaptureReport, 'views' | 'record'>): readonly ReportedPhoto[] {
  return views.map((view, index) => {
    const about = record?.views[index] ?? null;
    return { index, view, about, name: about?.photo ?? view.file };
  });
}

/** Photographs with the largest reprojection error first, then those without points. */
export function worstFirst(photos: readonly ReportedPhoto[]): readonly ReportedPhoto[] {
  return [...photos].sort((a, b) => (b.about?.errorPx ?? -1) - (a.about?.errorPx ?? -1));
}

/** The reprojection error of a photograph in words. */
export function errorWords(about: RecordedView | null): string {
  if (about === null) return 'not recorded';
  return about.errorPx === null
    ? 'no points'
    : `${about.errorPx.toFixed(2)} px over ${about.points === 1 ? '1 point' : `${about.points} points`}`;
}

/** A fact of a report, in words. */
export interface ReportFact {
  readonly label: string;
  readonly text: string;
}

const DEPTH_WORDS = { z: 'along the axes of the cameras', ray: 'along the rays of pixels' } as const;

interface Size {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** What was understood, in words. */
export function reportFacts({ record, views, vertexCount, triangleCount, sizeM }: CaptureReport): readonly ReportFact[] {
  const fact = (label: string, text: string | null | undefined): ReportFact[] => (text == null ? [] : [{ label, text }]);
  return [
    ...fact('Files', record?.form),
    ...fact('Photographs', `${views.length}, ${photographSizes(record?.views ?? views, views)}`),
    ...fact('Cameras', record && counts(record.views.map(({ model }) => model))),
    ...fact('Points', record && pointWords(record)),
    ...fact('Mesh', `${whole(vertexCount)} vertices, ${whole(triangleCount)} triangles`),
    ...fact('Depth', record && depthWords(record)),
    ...fact('Size', `${sizeM.map((m) => m.toFixed(2)).join(' × ')} m`),
    ...fact('Scale', record && unitWords(record)),
    ...fact('Up', record && `${record.up} axis of the reconstruction`),
    ...fact('Left out', record && leftOutWords(record)),
  ];
}

function whole(count: number): string {
  return count.toLocaleString('en-US');
}

function photographSizes(taken: readonly Size[], packed: readonly Size[]): string {
  const [before, after] = [rangeOfSizes(taken), rangeOfSizes(packed)];
  return before === after ? before : `${before}, packed as ${after}`;
}

function rangeOfSizes(sizes: readonly Size[]): string {
  const texts = new Set(sizes.map(({ widthPx, heightPx }) => `${widthPx} × ${heightPx}`));
  return texts.size <= 2 ? `${[...texts].join(' and ')} px` : `of ${texts.size} sizes`;
}

function unitWords({ metersPerUnit, scale }: ImportRecord): string {
  const unit = `1 unit of the reconstruction is ${Number(metersPerUnit.toPrecision(4))} m`;
  return scale === null ? unit : `${unit}, ${scaleWords(scale).text}`;
}

/** What is to be done about the scale; null if it is known, or if nothing was recorded of it. */
export function scaleAdvice(record: ImportRecord | null): string | null {
  return record?.scale ? scaleWords(record.scale).advice : null;
}

/** Each word with its number, the most frequent first. */
function counts(words: readonly string[]): string {
  const found = new Map<string, number>();
  for (const word of words) found.set(word, (found.get(word) ?? 0) + 1);
  const sorted = [...found].sort(([, a], [, b]) => b - a);
  return sorted.map(([word, count]) => `${count} × ${word}`).join(', ');
}

function pointWords({ pointCount, views }: ImportRecord): string {
  const errors = views.flatMap(({ errorPx }) => errorPx ?? []);
  if (errors.length === 0) return 'none';
  const mean = errors.reduce((sum, error) => sum + error, 0) / errors.length;
  return `${whole(pointCount)}, mean reprojection error ${mean.toFixed(2)} px`;
}

function depthWords({ depth, depthTriangles }: ImportRecord): string {
  const meshes = depthTriangles > 0 ? `depth meshes of ${whole(depthTriangles)} triangles` : 'no depth meshes';
  if (depth === null) return depthTriangles > 0 ? `${meshes}, from the mesh` : meshes;
  const unit = typeof depth.unit === 'number' ? `${depth.unit} m` : depth.unit;
  const files = depth.count === 1 ? '1 file' : `${depth.count} files`;
  return `${files}, ${DEPTH_WORDS[depth.kind]}, unit ${unit}; ${meshes}`;
}

function leftOutWords({ withoutPhotograph, withoutCamera }: ImportRecord): string {
  const listed = (names: readonly string[], reason: string): string[] => (names.length === 0 ? [] : [`${names.join(', ')} (${reason})`]);
  const all = [...listed(withoutPhotograph, 'no photograph'), ...listed(withoutCamera, 'no camera')];
  return all.length === 0 ? 'nothing' : all.join('; ');
}
