import type { HitRecord, HitSource, MeasuredRoom, Ray } from '../../../../nodes/kit/hit-test.ts';
import type { SessionFrame } from '../../../../nodes/kit/session.ts';
import { setSurfacePose } from '../../../../nodes/kit/surface-pose.ts';
import type { DepthImages } from '../depth-images.ts';
import { createMeeting, type Meeting } from '../ray.ts';
import { castAtDepth } from './cast-depth.ts';
import { castAtMesh } from './cast-mesh.ts';
import { castAtFloor, castAtPlane } from './cast-plane.ts';

// Filled and read within one call.
const scratchMeeting = createMeeting();
const scratchBest = createMeeting();

/** All sources of hits, in the order in which they are tried. */
export const HIT_SOURCES: readonly HitSource[] = ['session', 'plane', 'mesh', 'depth', 'voxels', 'floor'];

/** What answers rays besides the frame. */
export interface RoomSources {
  readonly depth: DepthImages;
  /** The rooms that nodes measure. */
  readonly measured: ReadonlySet<MeasuredRoom>;
}

/**
 * Finds the first hit of a ray with the room as the session describes it, from the first source that has a hit.
 *
 * @returns False if nothing is hit; `out` is then unchanged.
 */
export function castAtRoom(
  out: HitRecord,
  ray: Ray,
  frame: SessionFrame,
  { depth, measured }: RoomSources,
  sources: readonly HitSource[],
): boolean {
  for (let i = 0; i < HIT_SOURCES.length; i++) {
    const source = HIT_SOURCES[i];
    if (!source || !sources.includes(source)) continue;
    scratchFound.label = '';
    scratchFound.frame = frame.index;
    if (!castAt(source, ray, frame, depth, measured)) continue;
    writeHit(out, scratchBest, ray, frame);
    out.source = source;
    out.label = scratchFound.label;
    out.frame = scratchFound.frame;
    return true;
  }
  return false;
}

const scratchFound = { label: '', frame: 0 };

function castAt(source: HitSource, ray: Ray, frame: SessionFrame, depth: DepthImages, measured: ReadonlySet<MeasuredRoom>): boolean {
  switch (source) {
    case 'session':
      return false;
    case 'plane':
    case 'mesh':
      return castAtSurfaces(source, ray, frame);
    case 'depth':
      for (let i = 0; i < frame.viewCount; i++) {
        const image = depth.image(frame, i);
        if (!image || !castAtDepth(scratchBest, ray, image)) continue;
        scratchFound.frame = image.frame;
        return true;
      }
      return false;
    case 'voxels':
      for (const room of measured) if (room.cast(scratchBest, ray)) return true;
      return false;
    case 'floor':
      return castAtFloor(scratchBest, ray);
  }
}

function castAtSurfaces(kind: 'plane' | 'mesh', ray: Ray, { surfaces }: SessionFrame): boolean {
  let found = false;
  const count = (kind === 'plane' ? surfaces?.planes.length : surfaces?.meshes.length) ?? 0;
  for (let i = 0; i < count; i++) {
    const plane = kind === 'plane' ? surfaces?.planes[i] : undefined;
    const mesh = kind === 'mesh' ? surfaces?.meshes[i] : undefined;
    const meets = plane ? castAtPlane(scratchMeeting, ray, plane) : mesh ? castAtMesh(scratchMeeting, ray, mesh) : false;
    if (!meets || (found && scratchMeeting.distanceM >= scratchBest.distanceM)) continue;
    found = true;
    scratchBest.distanceM = scratchMeeting.distanceM;
    scratchBest.nx = scratchMeeting.nx;
    scratchBest.ny = scratchMeeting.ny;
    scratchBest.nz = scratchMeeting.nz;
    scratchFound.label = plane?.label ?? mesh?.label ?? '';
  }
  return found;
}

/** Writes the pose and distance of a hit. The other members are reset to those of a hit that no device found. */
export function writeHit(out: HitRecord, { distanceM, nx, ny, nz }: Meeting, ray: Ray, frame: SessionFrame): void {
  const first = frame.views[0]?.worldFromView;
  // Between the eyes.
  const second = (frame.viewCount > 1 ? frame.views[1]?.worldFromView : undefined) ?? first;
  out.distanceM = distanceM;
  out.anchorable = false;
  out.pointer = 0;
  out.label = '';
  out.frame = frame.index;
  setSurfacePose(
    out.worldFromHit,
    ray.ox + ray.dx * distanceM,
    ray.oy + ray.dy * distanceM,
    ray.oz + ray.dz * distanceM,
    nx,
    ny,
    nz,
    ray.ox,
    ray.oy,
    ray.oz,
    ((first?.[12] ?? ray.ox) + (second?.[12] ?? ray.ox)) / 2,
    ((first?.[14] ?? ray.oz) + (second?.[14] ?? ray.oz)) / 2,
  );
}
