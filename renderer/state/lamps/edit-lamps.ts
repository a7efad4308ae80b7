import type { FoundLamp, FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import { endGesture } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';
import { editParams } from '../params/edit-params.ts';

/** Number of lamps that have params of their own: the strongest ones. */
export const MAX_CHANGED = 3;
/** Decimals of stored angles in radians. Errors are below 0.01°. */
const DIGITS = 4;

/** The direction of a lamp, as the params of a pinned lamp store it. */
export interface LampDirection {
  readonly azimuthRad: number;
  readonly elevationRad: number;
}

/** A point of the panorama, as fractions of its width and height from the top left. */
export interface PanoramaPlace {
  readonly x: number;
  readonly y: number;
}

export function directionOf({ towards: [x, y, z] }: Pick<FoundLamp, 'towards'>): LampDirection {
  return { azimuthRad: Math.atan2(x, z), elevationRad: Math.asin(Math.min(1, Math.max(-1, y))) };
}

/** Converts a direction to a point of the panorama, whose center is -z. */
export function placeOf({ azimuthRad, elevationRad }: LampDirection): PanoramaPlace {
  const right = Math.PI - azimuthRad;
  const part = right / (2 * Math.PI) + 0.5;
  return { x: part - Math.floor(part), y: 0.5 - elevationRad / Math.PI };
}

/** The direction of a point of the panorama. A point beside the panorama wraps around; one above or below it gets the nearest latitude. */
export function directionAtPlace({ x, y }: PanoramaPlace): LampDirection {
  const right = (x - Math.floor(x) - 0.5) * 2 * Math.PI;
  const azimuth = Math.PI - right;
  return {
    azimuthRad: azimuth > Math.PI ? azimuth - 2 * Math.PI : azimuth,
    elevationRad: (0.5 - Math.min(1, Math.max(0, y))) * Math.PI,
  };
}

/** Pins a lamp to a direction. Calls until `endGesture` form one undo step. */
export function moveLamp(editor: Editor, node: string, lamp: number, { azimuthRad, elevationRad }: LampDirection): void {
  const edits = [
    { param: `lamp${lamp}Pinned`, value: true },
    { param: `lamp${lamp}AzimuthRad`, value: Number(azimuthRad.toFixed(DIGITS)) },
    { param: `lamp${lamp}ElevationRad`, value: Number(elevationRad.toFixed(DIGITS)) },
  ];
  editParams(editor, `Move lamp ${lamp}`, node, edits, `lamp ${node} ${lamp}`);
}

/** Pins a lamp where it was found, or unpins it, so that it returns to where it is found. */
export function pinLamp(editor: Editor, node: string, lamp: number, found: FoundLamps, isPinned: boolean): void {
  const at = found.lamps[lamp - 1];
  endGesture(editor);
  if (isPinned && at) moveLamp(editor, node, lamp, directionOf(at));
  else editParams(editor, `Unpin lamp ${lamp}`, node, [{ param: `lamp${lamp}Pinned`, value: false }], `lamp ${node} ${lamp}`);
  endGesture(editor);
}

/** Whether a param belongs to a single lamp. The lamps section of the inspector shows such params. */
export function isOfOneLamp(param: string): boolean {
  return /^lamp[1-3][A-Z]/.test(param);
}
