import type { HostOutput } from '../../../app/contract/contract.ts';
import { packedSidePx } from '../../../export/captures/packed-side.ts';
import type { CaptureDocument } from '../../../nodes/kit/capture.ts';
import { type CaptureSize, phoneCaptureSize } from '../../../nodes/kit/capture-size.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import { asked } from './outside-run.ts';

/** What the import of a folder must decide before. */
export type FolderSurvey = HostOutput<'photographs.survey'>;

/** Reads what the import of a folder must decide before, or why the folder cannot be imported. */
export function surveyPhotographs(editor: Editor, folder: string): Promise<FolderSurvey | Diagnostic | null> {
  return asked(editor, (handle) => editor.host.call('photographs.survey', { handle, folder }));
}

/** What the packed photographs of a folder take, in advance. */
export interface PackedEstimate {
  readonly pageBytes: number;
  readonly phone: CaptureSize;
  /** Longest side of the packed photographs. */
  readonly sidePx: number;
}

/** Of photographs that are encoded anew as AVIF files: 0.23 at 320 × 240 pixels of a room, less in larger ones. */
const AVIF_BYTES_PER_PIXEL = 0.17;
/** Position of a vertex, and three indices of a triangle. */
const MESH_BYTES = 12;

/** Estimates what photographs take if their longest side is reduced to `maxSidePx`. Null without photographs. */
export function estimatePacked(
  { photographs, mesh }: Pick<FolderSurvey, 'photographs' | 'mesh'>,
  maxSidePx: number,
): PackedEstimate | null {
  if (photographs.length === 0) return null;
  let photoBytes = 0;
  const views = photographs.map(({ widthPx, heightPx, bytes, isKept, isAround }) => {
    const factor = Math.min(1, packedSidePx(maxSidePx, isAround) / Math.max(widthPx, heightPx, 1));
    const [width, height] = [Math.max(1, Math.round(widthPx * factor)), Math.max(1, Math.round(heightPx * factor))];
    photoBytes += isKept && factor === 1 ? bytes : width * height * AVIF_BYTES_PER_PIXEL;
    return { file: '', widthPx: width, heightPx: height, fxPx: 1, fyPx: 1, cxPx: 0, cyPx: 0, worldFromCamera: [] };
  });
  const { vertexCount, triangleCount } = mesh ?? { vertexCount: 0, triangleCount: 0 };
  const document: CaptureDocument = { format: 'scrim-capture', version: 1, mesh: { file: '', vertexCount, triangleCount }, views };
  return {
    pageBytes: Math.round(photoBytes) + MESH_BYTES * (vertexCount + triangleCount),
    phone: phoneCaptureSize(document, false),
    sidePx: Math.max(...views.map(({ widthPx, heightPx }) => Math.max(widthPx, heightPx))),
  };
}
