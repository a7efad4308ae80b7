import { Vector3 } from 'three';
import type { PrimaryLight } from './room.ts';

/** The strongest light of a room that brings none of its own, which may be moved. */
export interface MovableLight {
  /** As it stands now. */
  readonly light: PrimaryLight;
  /** Unit vector towards it; the same object however it moves, for materials to read. */
  readonly towardsWorld: Vector3;
  /** `Room.moveLight`. */
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
