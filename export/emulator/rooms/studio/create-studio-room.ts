import { createBoxRoom } from '../box-room.ts';
import type { Room } from '../room.ts';
export function createStudioRoom(): Room {
  return createBoxRoom([{ label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [6, 0.1, 6] }]);
}
