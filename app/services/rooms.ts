/** The emulated rooms that `export/emulator` knows by name. */
export const ROOMS = [
  { name: 'living_room', title: 'Living room' },
  { name: 'meeting_room', title: 'Meeting room' },
  { name: 'music_room', title: 'Music room' },
  { name: 'office_large', title: 'Large office' },
  { name: 'office_small', title: 'Small office' },
] as const;
