import type { Diagnostic, Result } from '../../../../nodes/kit/diagnostics.ts';
import type { FrameTimes } from '../../../../nodes/kit/frame-times.ts';
import type { DetectedSurfaces, LightEstimate } from '../../../../nodes/kit/session.ts';
import { readVoxelFile } from '../../../../nodes/kit/voxel-file.ts';
import type { AssetSource } from '../../assets/asset-source.ts';
import type { SessionFile, SessionFileLight, SessionFileSurface } from '../session-format.ts';
import { brokenSession, readSessionFile, SESSION_FILE } from './read-session-file.ts';

/** A validated session folder, without its images. */
export interface Recording {
  readonly file: SessionFile;
  readonly frames: FrameTimes;
  /** Light estimate of each frame. */
  readonly lights: readonly (LightEstimate | null)[];
  /** Surfaces of all frames; null if there are none. */
  readonly surfaces: DetectedSurfaces | null;
  /** The room as voxels when the recording began; null if there are none. */
  readonly room: Uint8Array | null;
}

export async function openRecording(files: AssetSource): Promise<Result<Recording>> {
  const text = await readText(files);
  if (text.output === null) return { output: null, diagnostics: text.diagnostics };
  const json = parse(text.output);
  if (json.output === null) return { output: null, diagnostics: json.diagnostics };
  const { output: file, diagnostics } = readSessionFile(json.output.value);
  if (!file) return { output: null, diagnostics };
  const { bytes: room, problems } = await readRoom(files, file);
  const lights = file.frames.map((frame) => toLight(frame.light ?? file.light));
  return {
    output: { file, frames: framesOf(file), lights, surfaces: toSurfaces(file.surfaces ?? []), room },
    diagnostics: [...diagnostics, ...problems],
  };
}

/** Reads the voxels. A recording whose voxels cannot be read plays without them. */
async function readRoom(
  files: AssetSource,
  { room: path }: SessionFile,
): Promise<{ readonly bytes: Uint8Array | null; readonly problems: readonly Diagnostic[] }> {
  if (path === undefined) return { bytes: null, problems: [] };
  const warn = (reason: string) => ({
    bytes: null,
    problems: [
      { ...brokenSession(`The room “${path}” cannot be used: ${reason} The session plays without it.`), severity: 'warning' as const },
    ],
  });
  try {
    const bytes = new Uint8Array(await files.load(path));
    const { problem } = readVoxelFile(bytes);
    return problem === null ? { bytes, problems: [] } : warn(problem);
  } catch (error) {
    return warn(`${error instanceof Error ? error.message : String(error)}.`);
  }
}

function framesOf({ frames, frameRateHz }: SessionFile): FrameTimes {
  const startS = frames[0]?.timeS ?? 0;
  const timesS = frames.map(({ timeS }) => timeS - startS);
  return { timesS, durationS: (timesS.at(-1) ?? 0) + 1 / frameRateHz };
}

async function readText(files: AssetSource): Promise<Result<string>> {
  try {
    return { output: new TextDecoder().decode(await files.load(SESSION_FILE)), diagnostics: [] };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { output: null, diagnostics: [brokenSession(`The session folder cannot be read: ${reason}.`)] };
  }
}

function parse(text: string): Result<{ readonly value: unknown }> {
  try {
    return { output: { value: JSON.parse(text) as unknown }, diagnostics: [] };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { output: null, diagnostics: [brokenSession(`session.json is not valid JSON: ${reason}.`)] };
  }
}

function toLight(light: SessionFileLight | undefined): LightEstimate | null {
  if (!light) return null;
  return {
    sphericalHarmonics: Float32Array.from(light.sphericalHarmonics),
    primaryDirectionWorld: Float32Array.from(light.primaryDirectionWorld),
    primaryIntensity: Float32Array.from(light.primaryIntensity),
  };
}

function toSurfaces(surfaces: readonly SessionFileSurface[]): DetectedSurfaces | null {
  if (surfaces.length === 0) return null;
  const planes = surfaces.map(({ id, orientation, label, worldFromPlane, polygonXZ }) => ({
    id,
    version: 0,
    label: label ?? '',
    worldFromSurface: Float32Array.from(worldFromPlane),
    orientation,
    outlineXZ: Float32Array.from(polygonXZ.flat()),
  }));
  return { planes, meshes: [] };
}
