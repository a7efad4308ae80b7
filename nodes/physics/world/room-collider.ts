import { emptyVoxels, readVoxelFile, writeVoxelFile } from '../../kit/voxel-file.ts';
import type { ContactList } from './contact.ts';
import { FIXED_BODY, type PhysicsCommand } from './protocol.ts';
import { RigidBody } from './rigid-body.ts';
import { castOnSurface, collideSurface } from './surface-contacts.ts';
import type { CastRoom } from './sweep.ts';
import { castOnVoxels, collideVoxels } from './voxel-contacts.ts';
import { createVoxelGrid, type VoxelGrid } from './voxel-grid.ts';

/** The measured room of an engine: its voxels, and how bodies meet them. Without a room, nothing collides. */
export interface RoomCollider {
  apply(command: Extract<PhysicsCommand, { kind: 'room' | 'depth' | 'load-room' | 'move-room' }>): void;
  /** Adds the contacts of a body with the room. */
  collide(body: RigidBody, stepS: number, out: ContactList): void;
  readonly cast: CastRoom;
  hasChanged: VoxelGrid['hasChanged'];
  /** The height below which no voxel is occupied, meters; minus infinity without a room. */
  readonly lowestM: number;
  /** As `PhysicsEngine.voxels`. */
  voxels(): Float32Array;
  /** As `PhysicsEngine.roomFile`. */
  file(): Uint8Array | null;
}

export function createRoomCollider(): RoomCollider {
  let grid: VoxelGrid | null = null;
  /** The static body that stands for the room in contacts. */
  const room = new RigidBody(0, FIXED_BODY);

  return {
    apply: (command) => {
      switch (command.kind) {
        case 'room':
          grid = command.room && createVoxelGrid(command.room);
          room.description = { ...FIXED_BODY, friction: command.friction, restitution: command.restitution };
          break;
        case 'depth':
          grid?.update(command.frame);
          break;
        case 'load-room':
          grid?.load(readVoxelFile(command.file).voxels ?? emptyVoxels(grid.settings.edgeM, 0), command.worldFromFile);
          break;
        case 'move-room':
          grid?.load(grid.save(), command.worldFromFormer);
          break;
      }
    },
    collide: (body, stepS, out) => {
      if (grid?.surface) collideSurface(room, grid.surface, grid.settings.edgeM, body, stepS, out);
      else if (grid) collideVoxels(room, grid, body, stepS, out);
    },
    cast: (from, direction, lengthM, normal) => {
      if (!grid) return Number.POSITIVE_INFINITY;
      if (grid.surface) return castOnSurface(grid.surface, grid.settings.edgeM, from, direction, lengthM, normal);
      return castOnVoxels(grid, from, direction, lengthM, normal);
    },
    hasChanged: (...box) => grid?.hasChanged(...box) ?? false,
    get lowestM() {
      return grid?.lowestM ?? Number.NEGATIVE_INFINITY;
    },
    voxels: () => {
      const middles: number[] = [];
      const edgeM = grid?.settings.edgeM ?? 0;
      grid?.forEachOccupied((x, y, z) => middles.push((x + 0.5) * edgeM, (y + 0.5) * edgeM, (z + 0.5) * edgeM));
      return Float32Array.from(middles);
    },
    file: () => grid && writeVoxelFile(grid.save()),
  };
}
