import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { DepthKind } from '../depth/depth-map.ts';
import type { DepthUnit } from '../depth/depth-scale.ts';
import { AXES, type Axis } from '../upright.ts';
import { isScaleSource, type ScaleSource } from './scale-source.ts';

/** The name of the record in the folder of a capture. Pages do not contain it. */
export const IMPORT_FILE = 'import.json';

/** The most points of a photograph that a record has: some 8 KB. */
export const MOST_PLACES = 300;

/** What an import understood of the files that it read. Afterwards, these may be gone. */
export interface ImportRecord {
  readonly format: 'scrim-import-record';
  readonly version: 2;
  /** What the files were, such as `COLMAP (text)`. */
  readonly form: string;
  readonly up: Axis;
  /** Meters per unit of the reconstruction. */
  readonly metersPerUnit: number;
  /** Where the scale is from; null for records of version 1, which do not say it. */
  readonly scale: ScaleSource | null;
  readonly pointCount: number;
  /** What the depth files have, and how many there were; null without them. */
  readonly depth: { readonly unit: DepthUnit; readonly kind: DepthKind; readonly count: number } | null;
  /** Triangles of all depth meshes together. */
  readonly depthTriangles: number;
  /** Cameras that were left out, because they have no photograph: the names of these. */
  readonly withoutPhotograph: readonly string[];
  /** Photographs that were left out, because they have no camera. */
  readonly withoutCamera: readonly string[];
  readonly warnings: readonly string[];
  /** In the order of the capture. */
  readonly views: readonly RecordedView[];
}

/** A photograph before its import. */
export interface RecordedView {
  readonly photo: string;
  /** The camera model by its name, such as `SIMPLE_RADIAL`. */
  readonly model: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Mean reprojection error in pixels of the photograph; null if the files have no points. */
  readonly errorPx: number | null;
  /** Number of points that the error is measured with. */
  readonly points: number;
  /** Some of the points, as `reprojectedPlaces` gives them: 4 numbers each, in pixels of the imported photograph. */
  readonly places: readonly number[];
}

/** Writes `import.json`. */
export function importRecordFile(record: Omit<ImportRecord, 'format' | 'version'>): Uint8Array {
  const whole: ImportRecord = { format: 'scrim-import-record', version: 2, ...record };
  return new TextEncoder().encode(`${JSON.stringify(whole)}\n`);
}

/**
 * Reads `import.json`.
 *
 * @param views Number of views of the capture.
 * @throws CaptureError if it is no record of such a capture.
 */
export function readImportRecord(text: string, views: number): ImportRecord {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    throw new CaptureError(`its ${IMPORT_FILE} is not valid JSON`);
  }
  const record = upgraded(json);
  if (!isRecord(record)) throw new CaptureError(`its ${IMPORT_FILE} does not say what an import understood`);
  if (record.views.length !== views)
    throw new CaptureError(`its ${IMPORT_FILE} has ${record.views.length} views, but ${views} are in the capture`);
  return record;
}

/** Version 1 does not say where the scale is from. */
function upgraded(json: unknown): unknown {
  const fields = fieldsOf(json);
  return fields.version === 1 ? { ...fields, version: 2, scale: null } : json;
}

function isRecord(json: unknown): json is ImportRecord {
  const { format, version, form, up, metersPerUnit, scale, pointCount, depth, depthTriangles, views, ...lists } = fieldsOf(json);
  const { withoutPhotograph, withoutCamera, warnings } = lists;
  return (
    format === 'scrim-import-record' &&
    version === 2 &&
    typeof form === 'string' &&
    AXES.some((axis) => axis === up) &&
    [metersPerUnit, pointCount, depthTriangles].every(Number.isFinite) &&
    (scale === null || isScaleSource(fieldsOf(scale))) &&
    (depth === null || isDepth(fieldsOf(depth))) &&
    [withoutPhotograph, withoutCamera, warnings].every(areTexts) &&
    Array.isArray(views) &&
    views.every((view) => isView(fieldsOf(view)))
  );
}

function isDepth({ unit, kind, count }: Fields): boolean {
  return ['string', 'number'].includes(typeof unit) && (kind === 'z' || kind === 'ray') && Number.isFinite(count);
}

function isView({ photo, model, widthPx, heightPx, errorPx, points, places }: Fields): boolean {
  const isPlaced = Array.isArray(places) && places.length % 4 === 0 && places.every(Number.isFinite);
  return areTexts([photo, model]) && [widthPx, heightPx, errorPx ?? 0, points].every(Number.isFinite) && isPlaced;
}

type Fields = Readonly<Record<string, unknown>>;

function fieldsOf(value: unknown): Fields {
  return typeof value === 'object' && value !== null ? (value as Fields) : {};
}

function areTexts(value: unknown): boolean {
  return Array.isArray(value) && value.every((text) => typeof text === 'string');
}
