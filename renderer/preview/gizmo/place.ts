import { Euler, type Quaternion, Vector3 } from 'three';
import type { Handle } from '../../../nodes/kit/handles.ts';
import type { GizmoMode } from '../../preview-protocol.ts';

/** The transform of a gizmo target, relative to the nodes after it. */
export interface Place {
  readonly position: Vector3;
  readonly quaternion: Quaternion;
  readonly scale: Vector3;
}

export type HandleNames = Readonly<Partial<Record<Handle, string>>>;

/** Reads a param of the running program; null if it does not exist. */
export type ReadParam = (param: string) => readonly number[] | null;

/** Least scale of the gizmo. At 0 it would be invisible, and factors would have no effect. */
const LEAST_SCALE = 1e-3;

// Written and read within one call. The rotation order is that of `objects/transform`: z, then x, then y.
const scratchEuler = new Euler(0, 0, 0, 'YXZ');
const scratchVector = new Vector3();
const AHEAD = new Vector3(0, 0, 1);

export function readPlace(handles: HandleNames, read: ReadParam, out: Place): void {
  const values = (handle: Handle) => {
    const param = handles[handle];
    return param === undefined ? null : read(param);
  };
  out.position.set(0, 0, 0);
  const position = values('position') ?? values('step');
  if (position) out.position.fromArray(position);
  const [radius] = values('radius') ?? [];
  if (radius !== undefined) out.position.z = radius;
  const rotation = values('rotation');
  const aim = values('aim');
  const [azimuth = 0] = values('azimuth') ?? values('turn') ?? [];
  const [elevation = 0] = values('elevation') ?? [];
  if (rotation) scratchEuler.set(rotation[0] ?? 0, rotation[1] ?? 0, rotation[2] ?? 0);
  else if (aim) {
    scratchVector.fromArray(aim).sub(out.position).normalize();
    scratchEuler.set(-Math.asin(scratchVector.y), Math.atan2(scratchVector.x, scratchVector.z), 0);
  } else scratchEuler.set(-elevation, azimuth, 0);
  out.quaternion.setFromEuler(scratchEuler);
  const scale = values('scale') ?? [1];
  const [x = 1, y = x, z = x] = scale;
  out.scale.set(Math.max(x, LEAST_SCALE), Math.max(y, LEAST_SCALE), Math.max(z, LEAST_SCALE));
}

/** Computes the param values of the gizmo target after a drag from one transform to another in this mode. */
export function paramsOf(
  mode: GizmoMode,
  handles: HandleNames,
  read: ReadParam,
  from: Place,
  to: Place,
): Readonly<Record<string, number | readonly number[]>> {
  const { rotation, scale, aim, elevation, radius } = handles;
  switch (mode) {
    case 'move': {
      const position = handles.position ?? handles.step;
      if (position !== undefined) return { [position]: to.position.toArray() };
      return radius === undefined ? {} : { [radius]: to.position.z };
    }
    case 'rotate': {
      const { x, y, z } = scratchEuler.setFromQuaternion(to.quaternion);
      if (rotation !== undefined) return { [rotation]: [x, y, z] };
      if (aim !== undefined) {
        const distance = scratchVector.fromArray(read(aim) ?? [0, 0, 0]).distanceTo(to.position);
        return { [aim]: scratchVector.copy(AHEAD).applyQuaternion(to.quaternion).multiplyScalar(distance).add(to.position).toArray() };
      }
      const azimuth = handles.azimuth ?? handles.turn;
      return { ...(azimuth === undefined ? {} : { [azimuth]: y }), ...(elevation === undefined ? {} : { [elevation]: -x }) };
    }
    case 'scale': {
      if (scale === undefined) return {};
      const sizes = to.scale.toArray();
      // A uniform scale uses the factor of the dragged axis.
      return { [scale]: (read(scale)?.length ?? 1) === 1 ? pulled(from.scale, to.scale) : sizes };
    }
  }
}

function pulled(from: Vector3, to: Vector3): number {
  const most = [to.x / from.x, to.y / from.y, to.z / from.z].reduce((a, b) => (Math.abs(b - 1) > Math.abs(a - 1) ? b : a));
  return from.x * most;
}
