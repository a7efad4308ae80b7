import { Matrix4, Vector3 } from 'three';
import { addPointer, createPointer, type MutablePointer } from '../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame, type MutableFrame } from '../../export/runtime/sessions/session-frame.ts';

export type Place = readonly [x: number, y: number, z: number];

export const EYES: Place = [0, 1.6, 0];

/** From the eyes, or from a place, to a place. */
export function rayTo(to: Place, from: Place = EYES): number[] {
  const origin = new Vector3(...from);
  return new Matrix4().lookAt(origin, new Vector3(...to), new Vector3(0, 1, 0.001)).setPosition(origin).elements;
}

export function pointer(
  id: number,
  phase: MutablePointer['phase'],
  ray: readonly number[],
  more: Partial<MutablePointer> = {},
): MutablePointer {
  const made = Object.assign(createPointer(), { id, phase, tapped: phase === 'end', ...more });
  made.worldFromRay.set(ray);
  return made;
}

/** A frame of a viewer who stands at `EYES` and looks along -z. */
export function frameOfEyes(): MutableFrame {
  const frame = Object.assign(createSessionFrame(), { viewCount: 1 });
  frame.views[0]?.worldFromView.set(new Matrix4().setPosition(...EYES).elements);
  return frame;
}

/** Begins the next frame, with these pointers and no others. */
export function nextFrame(frame: MutableFrame, pointers: readonly MutablePointer[]): void {
  frame.input.pointerCount = 0;
  for (const each of pointers) addPointer(frame.input, each);
  frame.index++;
}
