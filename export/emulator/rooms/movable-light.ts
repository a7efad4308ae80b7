import { Vector3 } from 'three';
import type { PrimaryLight } from './room.ts';

/** The strongest light of a room without lights of its own. */
export interface MovableLight {
  /** The current light. */
  readonly light: PrimaryLight;
  /** Unit vector towards the light. The object stays the same, so materials can hold it. */
  readonly towardsWorld: Vector3;
  /** Moves the light to this direction, or back to the original direction if it is null (`Room.moveLight`). */
  move(directionWorld: PrimaryLight['directionWorld'] | null): void;
}

const HOME: PrimaryLight = { directionWorld: [0.36, 0.8, 0.48], intensity: [1.9, 1.8, 1.65] };

export function createMovableLight(): MovableLight {
  const towardsWorld = new Vector3(...HOME.directionWorld);
  return {
    get light() {
      return { ...HOME, directionWorld: towardsWorld.toArray() };
    },
    towardsWorld,
    move: (directionWorld) => towardsWorld.set(...(directionWorld ?? HOME.directionWorld)),
  };
}
