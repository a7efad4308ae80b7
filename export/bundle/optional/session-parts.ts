import { entersSessions, type PageUse } from '../page-entry.ts';
import { absent, needs, type OptionalPart } from './part.ts';

const WRITE_IDENTITY = '(m) => { m[0] = m[5] = m[10] = m[15] = 1; }';

const readsView = (use: PageUse): boolean => use.readsView;

/** Parts of sessions and their input. */
export const SESSION_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/runtime/sessions/orbit/orbit-input.ts',
    isNeeded: readsView,
    otherwise: 'const nothing = () => {};\nexport const listenForOrbit = () => ({ settle: nothing, dispose: nothing });',
  },
  {
    file: 'export/runtime/sessions/orbit/orbit-pose.ts',
    isNeeded: readsView,
    otherwise: `export const ORBIT_DEFAULTS = {};\nexport const createOrbit = () => ({ writeWorldFromView: ${WRITE_IDENTITY} });`,
  },
  {
    file: 'export/runtime/sessions/camera/camera-viewer.ts',
    isNeeded: readsView,
    otherwise: `export const createCameraViewer = () => ({ writeWorldFromView: ${WRITE_IDENTITY} });`,
  },
  {
    // Without it, iPhones do not ask the visitor for the motion sensor.
    file: 'export/runtime/sessions/camera/orientation-sensor.ts',
    isNeeded: readsView,
    otherwise: `export const requestOrientationPermission = async () => 'absent';
export const listenForOrientation = () => ({ present: true, dispose: () => {} });`,
  },
  {
    file: 'export/runtime/sessions/input/session-input.ts',
    isNeeded: (use) => use.input || needs('planes')(use),
    otherwise: `export const MAX_POINTERS = 0;
export const MAX_TAPS = 0;
export const MAX_KEYS = 0;
export const createSessionInput = () => ({});
${absent('createPointer', 'addPointer', 'deriveTaps', 'rest', 'nextTap')}`,
  },
  {
    file: 'export/runtime/sessions/webxr/webxr-input.ts',
    isNeeded: entersSessions,
    otherwise: absent('createWebXrInput'),
  },
  {
    file: 'export/runtime/sessions/webxr/authored-room.ts',
    isNeeded: ({ tiers }) => tiers.has('authored-vr'),
    otherwise: absent('createAuthoredRoom'),
  },
  {
    file: 'export/runtime/sessions/webxr/webxr-light.ts',
    isNeeded: needs('light-estimation'),
    otherwise: absent('createWebXrLight'),
  },
  {
    file: 'export/runtime/sessions/webxr/webxr-detected-surfaces.ts',
    isNeeded: (use) => needs('planes')(use) || needs('meshes')(use),
    otherwise: 'export const createSurfaceReader = () => null;',
  },
  {
    file: 'export/runtime/sessions/webxr/room-capture.ts',
    isNeeded: needs('planes'),
    otherwise: 'export const createRoomCapture = () => null;',
  },
  {
    file: 'export/runtime/sessions/webxr/view-sources.ts',
    isNeeded: (use) => needs('depth')(use) || needs('camera-image')(use),
    otherwise: `const nothing = () => null;
export const createViewSources = () => ({ depth: nothing, cameraImage: nothing, dispose: nothing });`,
  },
  {
    file: 'export/runtime/sessions/webxr/cpu-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createCpuDepth'),
  },
  {
    file: 'export/runtime/sessions/webxr/gpu-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createGpuDepth'),
  },
  {
    file: 'export/runtime/sessions/webxr/reproject-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createDepthReprojector', 'isSameMatrix', 'isSameLens'),
  },
];
