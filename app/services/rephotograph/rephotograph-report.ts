import { basename, extname, join } from 'node:path';
import type { FileSink } from '../../../export/bundle/bundle-page.ts';
import type { ImageQuality } from '../../../export/captures/evaluate/image-quality.ts';
import { REPHOTOGRAPH_METHODS, type RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import { CAPTURE_FILE, type CaptureDocument, CaptureError, readCapture } from '../../../nodes/kit/capture.ts';
import { captureFilesProblem } from '../check-capture.ts';
import { errorCode, refusal } from '../file-errors.ts';
import type { FolderMark } from '../page-folder.ts';
import { readBytes, readText } from '../read-file.ts';
import { type MethodMeans, meansOf, type ReportedShot, type ReportedView, reportPage } from './report-page.ts';

export const REPHOTOGRAPH_MARK: FolderMark = { file: 'report.json', format: 'scrim-rephotograph', words: 'an earlier report' };

/** The figures of a photograph that was drawn by one method, and its pictures as PNG files. */
export interface MeasuredShot extends ImageQuality {
  readonly method: RephotographMethod;
  readonly picture: Uint8Array;
  readonly error: Uint8Array;
}

/** Writes a page with all pictures of a rephotographed capture, and a file with all figures. */
export interface RephotographReport {
  readonly views: readonly ReportedView[];
  /** Adds what was drawn of a photograph. Photographs are added in order, each with all methods. */
  add(index: number, shots: readonly MeasuredShot[]): Promise<void>;
  /** Writes `index.html` and `report.json`. */
  finish(): Promise<readonly MethodMeans[]>;
}

const MAX_CAPTURE_BYTES = 16 * 2 ** 20;
const MAX_PHOTO_BYTES = 256 * 2 ** 20;

/**
 * Reads a capture that is to be rephotographed.
 *
 * @param folder Real path of `assets/NAME.capture`.
 * @throws SCR032
 */
export async function readRephotographed(folder: string): Promise<CaptureDocument> {
  try {
    const document = readCapture(await readText(join(folder, CAPTURE_FILE), MAX_CAPTURE_BYTES));
    if (document.views.length < 2) throw new CaptureError('it has one photograph only, and none is left to draw it from');
    const problem = await captureFilesProblem(document, '', async (file) => join(folder, file));
    if (problem !== null) throw new CaptureError(problem.message.replace(/\.$/, ''));
    return document;
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR032', `${folder} cannot be rephotographed: ${error.message}.`);
    if (errorCode(error) !== 'ENOENT') throw error;
    throw refusal('SCR032', `${folder} is not a capture: it has no ${CAPTURE_FILE}.`, 'Name a folder assets/NAME.capture of a project.');
  }
}

/** The methods that can draw a capture. */
export function methodsOf({ views }: CaptureDocument): readonly RephotographMethod[] {
  const hasDepthMeshes = views.some(({ depthMesh }) => depthMesh);
  return REPHOTOGRAPH_METHODS.filter((method) => method !== 'depth-meshes' || hasDepthMeshes);
}

/** @param folder Real path of `assets/NAME.capture`, whose photographs are copied. */
export function createRephotographReport(
  sink: FileSink,
  folder: string,
  { views: photos }: CaptureDocument,
  blended: number,
): RephotographReport {
  const views: ReportedView[] = [];
  const files: { readonly path: string }[] = [];
  const write = async (path: string, bytes: Uint8Array): Promise<string> => {
    await sink.write(path, bytes);
    files.push({ path });
    return path;
  };
  return {
    views,
    add: async (index, shots) => {
      const file = photos[index]?.file ?? '';
      const stem = `views/${String(index).padStart(3, '0')}`;
      const photo = await write(`${stem}${extname(file)}`, await readBytes(join(folder, file), MAX_PHOTO_BYTES));
      const reported: ReportedShot[] = [];
      for (const { picture, error, ...shot } of shots) {
        reported.push({
          ...shot,
          picture: await write(`${stem}-${shot.method}.png`, picture),
          error: await write(`${stem}-${shot.method}-error.png`, error),
        });
      }
      views.push({ file, photo, shots: reported });
    },
    finish: async () => {
      const title = `${basename(folder).replace(/\.capture$/, '')}, rephotographed`;
      await write('index.html', new TextEncoder().encode(reportPage(title, views)));
      const means = meansOf(views);
      const report = { format: REPHOTOGRAPH_MARK.format, version: 1, blended, means, views, files };
      await sink.write(REPHOTOGRAPH_MARK.file, new TextEncoder().encode(`${JSON.stringify(report, null, 1)}\n`));
      return means;
    },
  };
}
