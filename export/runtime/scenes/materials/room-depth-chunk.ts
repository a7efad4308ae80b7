import { ROOM_DEPTH_TEXT } from '../../../program/room-depth.ts';

/** Declares `scrim_roomM` in materials once, because several patches may need it. */
export const ROOM_DEPTH_CHUNK = /* glsl */ `
#ifndef SCRIM_ROOM_DEPTH
#define SCRIM_ROOM_DEPTH
${ROOM_DEPTH_TEXT}
#endif
`;
