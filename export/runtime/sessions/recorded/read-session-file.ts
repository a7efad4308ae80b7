import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { SessionFile } from '../session-format.ts';

export const SESSION_FILE = 'session.json';

type Json = Readonly<Record<string, unknown>>;

/** Checks a parsed `session.json`; every mistake comes as SCR054 with its place in the file. */
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
    problems.push(`The session has version ${String(file.version)}, and this Scrim plays version 1.`);
    return;
  }
  checkPictures(file.color, 'color', problems);
  const depth = asObject(file.depth);
  if (file.depth !== undefined) {
    checkPictures(file.depth, 'depth', problems);
    if (!isPositive(depth?.metresPerUnit)) problems.push('"depth.metresPerUnit" has to be a number above 0.');
    if (depth?.kind !== 'z' && depth?.kind !== 'range') problems.push('"depth.kind" has to be "z" or "range".');
  }
  if (!isPositive(file.frameRateHz)) problems.push('"frameRateHz" has to be a number above 0.');
  if (file.light !== undefined) checkLight(file.light, 'light', problems);
  if (file.surfaces !== undefined) checkSurfaces(file.surfaces, problems);
  if (!Array.isArray(file.frames) || file.frames.length === 0) {
    problems.push('"frames" has to be a list of at least one frame.');
    return;
  }
  let earlierS = Number.NEGATIVE_INFINITY;
  file.frames.forEach((frame: unknown, i) => {
    checkFrame(frame, `frames[${i}]`, file.depth !== undefined, problems);
    const timeS = asObject(frame)?.timeS;
    if (!isNumber(timeS)) return;
    if (timeS <= earlierS) problems.push(`"frames[${i}].timeS" has to be later than that of the previous frame.`);
    earlierS = timeS;
  });
}

function checkFrame(value: unknown, place: string, hasDepth: boolean, problems: string[]): void {
  const frame = asObject(value);
  if (!isNumber(frame?.timeS)) problems.push(`"${place}.timeS" has to be a number of seconds.`);
  if (!isPath(frame?.color)) problems.push(`"${place}.color" has to be the path of a picture inside the session folder.`);
  if (frame?.depth !== undefined && !isPath(frame.depth)) {
    problems.push(`"${place}.depth" has to be the path of a depth picture inside the session folder.`);
  }
  if (frame?.depth !== undefined && !hasDepth)
    problems.push(`"${place}.depth" names a picture, but the file has no "depth" that describes it.`);
  if (!isNumbers(frame?.worldFromCamera, 16)) problems.push(`"${place}.worldFromCamera" has to be 16 numbers.`);
  if (frame?.light !== undefined) checkLight(frame.light, `${place}.light`, problems);
}

function checkSurfaces(value: unknown, problems: string[]): void {
  if (!Array.isArray(value)) {
    problems.push('"surfaces" has to be a list.');
    return;
  }
  const ids = new Set<unknown>();
  value.forEach((surface: unknown, i) => {
    const { id, kind, orientation, worldFromPlane, polygonXZ } = asObject(surface) ?? {};
    const place = `surfaces[${i}]`;
    if (typeof id !== 'string' || ids.has(id)) problems.push(`"${place}.id" has to be a text that no other surface has.`);
    ids.add(id);
    if (kind !== 'plane') problems.push(`"${place}.kind" has to be "plane".`);
    if (orientation !== 'horizontal' && orientation !== 'vertical') {
      problems.push(`"${place}.orientation" has to be "horizontal" or "vertical".`);
    }
    if (!isNumbers(worldFromPlane, 16)) problems.push(`"${place}.worldFromPlane" has to be 16 numbers.`);
    if (!Array.isArray(polygonXZ) || polygonXZ.length < 3 || !polygonXZ.every((corner) => isNumbers(corner, 2))) {
      problems.push(`"${place}.polygonXZ" has to be at least three corners of two numbers.`);
    }
  });
}

function checkPictures(value: unknown, place: string, problems: string[]): void {
  const pictures = asObject(value);
  if (!isPixels(pictures?.widthPx) || !isPixels(pictures?.heightPx)) {
    problems.push(`"${place}.widthPx" and "${place}.heightPx" have to be whole numbers of pixels.`);
  }
  const intrinsics = asObject(pictures?.intrinsics);
  if (!isPositive(intrinsics?.fxPx) || !isPositive(intrinsics?.fyPx) || !isNumber(intrinsics?.cxPx) || !isNumber(intrinsics?.cyPx)) {
    problems.push(`"${place}.intrinsics" has to hold the numbers fxPx, fyPx, cxPx and cyPx.`);
  }
}

function checkLight(value: unknown, place: string, problems: string[]): void {
  const light = asObject(value);
  if (!isNumbers(light?.sphericalHarmonics, 27)) problems.push(`"${place}.sphericalHarmonics" has to be 27 numbers.`);
  if (!isNumbers(light?.primaryDirectionWorld, 3)) problems.push(`"${place}.primaryDirectionWorld" has to be 3 numbers.`);
  if (!isNumbers(light?.primaryIntensity, 3)) problems.push(`"${place}.primaryIntensity" has to be 3 numbers.`);
}

function asObject(value: unknown): Json | undefined {
  return typeof value === 'object' && value !== null ? (value as Json) : undefined;
}

function isNumber(value: unknown): value is number {
  return typeof value === 'number' && Number.isFinite(value);
}

function isPositive(value: unknown): boolean {
  return isNumber(value) && value > 0;
}

function isPixels(value: unknown): boolean {
  return isPositive(value) && Number.isInteger(value);
}

function isNumbers(value: unknown, count: number): boolean {
  return Array.isArray(value) && value.length === count && value.every(isNumber);
}

/** Relative, and it stays inside the folder. */
function isPath(value: unknown): value is string {
  return typeof value === 'string' && value !== '' && !/^[/\\]|\\|:/.test(value) && !value.split('/').includes('..');
}
