import { dirname } from 'node:path';
import { DAMAGED_CAPTURE_FIX } from '../../../export/captures/file-faults.ts';
import { type CaptureReport, reportOfCapture } from '../../../export/captures/report/capture-report.ts';
import { IMPORT_FILE, readImportRecord } from '../../../export/captures/report/import-record.ts';
import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { HostOutput } from '../../contract/contract.ts';
import { resolveInside } from '../confine.ts';
import { errorCode, readRefusal, refusal } from '../file-errors.ts';
import { MAX_CAPTURE_TEXT_BYTES, readCaptureWithMesh } from '../read-capture.ts';
import { readText } from '../read-file.ts';

/**
 * Reads what is known of a capture: what its import understood, its cameras and its mesh.
 *
 * @param folder Real path of `assets/NAME.capture`.
 * @throws CaptureError if a file is damaged; SCR031; system errors if a file cannot be read.
 */
export async function readCaptureReport(folder: string): Promise<CaptureReport> {
  const { document, mesh } = await readCaptureWithMesh(folder);
  const recordFile = await resolveInside(folder, IMPORT_FILE);
  const record = await readText(recordFile, MAX_CAPTURE_TEXT_BYTES).catch((error: unknown) => {
    if (errorCode(error) === 'ENOENT') return null;
    throw error;
  });
  return reportOfCapture(document.views, mesh, record === null ? null : readImportRecord(record, document.views.length));
}

/**
 * Reads what is known of a capture of a project.
 *
 * @param root Real path of the project.
 * @param path Path of its `capture.json` in the project.
 * @throws SCR004, SCR031, SCR032
 */
export async function reportOfAsset(root: string, path: string): Promise<HostOutput<'capture.report'>> {
  const file = await resolveInside(root, path);
  try {
    return await readCaptureReport(dirname(file));
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR032', `${path} cannot be reported: ${error.message}.`, DAMAGED_CAPTURE_FIX);
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}
