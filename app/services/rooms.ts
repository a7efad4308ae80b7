/** An emulated room. `capture` is its file in `@iwer/sem/captures`; null for the emulator’s built-in room. */
export interface EmulatedRoom {
  readonly name: string;
  readonly title: string;
  readonly capture: string | null;
}

export const ROOMS: readonly EmulatedRoom[] = [
  { name: 'studio', title: 'Studio', capture: null },
  { name: 'living_room', title: 'Living room', capture: 'living_room.json' },
  { name: 'meeting_room', title: 'Meeting room', capture: 'meeting_room.json' },
  { name: 'music_room', title: 'Music room', capture: 'music_room.json' },
  { name: 'office_large', title: 'Large office', capture: 'office_large.json' },
  { name: 'office_small', title: 'Small office', capture: 'office_small.json' },
];
