import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { SessionFile } from '../session-format.ts';
import { asObject, checkInput, isNumber, isNumbers } from './check-input.ts';

export const SESSION_FILE = 'session.json';

/** Validates a parsed `session.json`. Every mistake is an SCR054 with its place in the file. */
export function readSessionFile(json: unknown): Result<SessionFile> {
  const problems: string[] = [];
  checkFile(json, problems);
  const diagnostics = problems.map(brokenSession);
  return { output: problems.length === 0 ? (json as SessionFile) : null, diagnostics };
}

export function brokenSession(message: string): Diagnostic {
  return {
    code: 'SCR054',
    severity: 'error',
    file: SESSION_FILE,
    message,
    fix: 'Compare the folder with docs/SESSION-FORMAT.md.',
  };
}

function checkFile(json: unknown, problems: string[]): void {
  const file = asObject(json);
  if (file?.format !== 'scrim-session') {
    problems.push('This is not a Scrim session: "format" is not "scrim-session".');
    return;
  }
  if (file.version !== 1) {
    problems.push(`Version ${String(file.version)} of the session is not supported. This Scrim plays version 1.`);
    return;
  }
  checkImages(file.color, 'color', problems);
  const depth = asObject(file.depth);
  if (file.depth !== undefined) {
    checkImages(file.depth, 'depth', problems);
    if (!isPositive(depth?.metresPerUnit)) problems.push('"depth.metresPerUnit" must be a number above 0.');
    if (depth?.kind !== 'z' && depth?.kind !== 'range') problems.push('"depth.kind" must be "z" or "range".');
  }
  if (!isPositive(file.frameRateHz)) problems.push('"frameRateHz" must be a number above 0.');
  if (file.light !== undefined) checkLight(file.light, 'light', problems);
  if (file.surfaces !== undefined) checkSurfaces(file.surfaces, problems);
  if (file.room !== undefined && !isPath(file.room)) problems.push('"room" must be the path of a voxel file inside the session folder.');
  if (!Array.isArray(file.frames) || file.frames.length === 0) {
    problems.push('"frames" must be a list of at least one frame.');
    return;
  }
  let earlierS = Number.NEGATIVE_INFINITY;
  file.frames.forEach((frame: unknown, i) => {
    checkFrame(frame, `frames[${i}]`, file.depth !== undefined, problems);
    const timeS = asObject(frame)?.timeS;
    if (!isNumber(timeS)) return;
    if (timeS <= earlierS) problems.push(`"frames[${i}].timeS" must be later than that of the previous frame.`);
    earlierS = timeS;
  });
}

function checkFrame(value: unknown, place: string, hasDepth: boolean, problems: string[]): void {
  const frame = asObject(value);
  if (!isNumber(frame?.timeS)) problems.push(`"${place}.timeS" must be a number of seconds.`);
  if (!isPath(frame?.color)) problems.push(`"${place}.color" must be the path of an image inside the session folder.`);
  if (frame?.depth !== undefined && !isPath(frame.depth)) {
    problems.push(`"${place}.depth" must be the path of a depth image inside the session folder.`);
  }
  if (frame?.depth !== undefined && !hasDepth) problems.push(`"${place}.depth" has no description. Add "depth" to the file.`);
  if (!isNumbers(frame?.worldFromCamera, 16)) problems.push(`"${place}.worldFromCamera" must be 16 numbers.`);
  if (frame?.light !== undefined) checkLight(frame.light, `${place}.light`, problems);
  if (frame?.input !== undefined) checkInput(frame.input, `${place}.input`, problems);
}

function checkSurfaces(value: unknown, problems: string[]): void {
  if (!Array.isArray(value)) {
    problems.push('"surfaces" must be a list.');
    return;
  }
  const ids = new Set<unknown>();
  value.forEach((surface: unknown, i) => {
    const { id, kind, orientation, worldFromPlane, polygonXZ } = asObject(surface) ?? {};
    const place = `surfaces[${i}]`;
    if (typeof id !== 'string' || ids.has(id)) problems.push(`"${place}.id" must be a unique text.`);
    ids.add(id);
    if (kind !== 'plane') problems.push(`"${place}.kind" must be "plane".`);
    if (orientation !== 'horizontal' && orientation !== 'vertical') {
      problems.push(`"${place}.orientation" must be "horizontal" or "vertical".`);
    }
    if (!isNumbers(worldFromPlane, 16)) problems.push(`"${place}.worldFromPlane" must be 16 numbers.`);
    if (!Array.isArray(polygonXZ) || polygonXZ.length < 3 || !polygonXZ.every((corner) => isNumbers(corner, 2))) {
      problems.push(`"${place}.polygonXZ" must be at least three corners of two numbers.`);
    }
  });
}

function checkImages(value: unknown, place: string, problems: string[]): void {
  const images = asObject(value);
  if (!isPixels(images?.widthPx) || !isPixels(images?.heightPx)) {
    problems.push(`"${place}.widthPx" and "${place}.heightPx" must be whole numbers of pixels.`);
  }
  const intrinsics = asObject(images?.intrinsics);
  if (!isPositive(intrinsics?.fxPx) || !isPositive(intrinsics?.fyPx) || !isNumber(intrinsics?.cxPx) || !isNumber(intrinsics?.cyPx)) {
    problems.push(`"${place}.intrinsics" must contain the numbers fxPx, fyPx, cxPx and cyPx.`);
  }
}

function checkLight(value: unknown, place: string, problems: string[]): void {
  const light = asObject(value);
  if (!isNumbers(light?.sphericalHarmonics, 27)) problems.push(`"${place}.sphericalHarmonics" must be 27 numbers.`);
  if (!isNumbers(light?.primaryDirectionWorld, 3)) problems.push(`"${place}.primaryDirectionWorld" must be 3 numbers.`);
  if (!isNumbers(light?.primaryIntensity, 3)) problems.push(`"${place}.primaryIntensity" must be 3 numbers.`);
}

function isPositive(value: unknown): boolean {
  return isNumber(value) && value > 0;
}

function isPixels(value: unknown): boolean {
  return isPositive(value) && Number.isInteger(value);
}

/** Whether the value is a relative path inside the folder. */
function isPath(value: unknown): value is string {
  return typeof value === 'string' && value !== '' && !/^[/\\]|\\|:/.test(value) && !value.split('/').includes('..');
}
