import type { PanoramaCapture } from '../../runtime/panorama/capture.ts';
import type { StepBarState } from './step-bar.ts';

/**
 * Phase of the step that takes a panorama.
 *
 * - `idle`: there is nothing to do, or the visitor skipped the step.
 * - `resuming`: asks whether to use photos of an earlier session; `aligning`: finds how these are rotated in this session.
 * - `taking`, `stitching`: takes photos, and makes the panorama of them; `failed`: stitching failed.
 * - `locating`: finds how a panorama of an earlier visit is rotated; `asking`: asks the visitor to point at a lamp.
 * - `ready`: the panorama is in use.
 */
export type StepPhase = 'idle' | 'resuming' | 'aligning' | 'taking' | 'stitching' | 'failed' | 'locating' | 'asking' | 'ready';

interface StepFacts {
  readonly capture: Pick<PanoramaCapture, 'targets' | 'shots' | 'state' | 'isAway' | 'held'>;
  /** Progress of stitching, as a fraction in [0, 1]. */
  readonly progress: number;
  readonly failure: string;
  /** Number of photos of an earlier session. */
  readonly beforeCount: number;
}

/** What the bar says in each phase; an empty text hides it. */
export function barText(phase: StepPhase, facts: StepFacts): Pick<StepBarState, 'text' | 'progress'> {
  switch (phase) {
    case 'idle':
      return { text: '', progress: null };
    case 'taking':
      return takingText(facts.capture);
    case 'stitching':
      return { text: `Making the panorama: ${Math.round(facts.progress * 100)} %`, progress: facts.progress };
    case 'failed':
      return { text: `The panorama could not be made: ${facts.failure.replace(/\.$/, '')}.`, progress: null };
    case 'resuming':
      return { text: `There are ${facts.beforeCount} photos of your last try. Continue with them?`, progress: null };
    case 'aligning':
      return { text: 'Point at something that you have photographed before, until the page recognizes it.', progress: null };
    case 'locating':
      return { text: 'Look around slowly, until the page recognizes the room.', progress: null };
    case 'asking':
      return { text: 'The page does not recognize the room. Point the camera at its brightest lamp or window.', progress: null };
    case 'ready':
      return { text: 'The light is that of your room. The panorama stays on this device.', progress: null };
    default:
      return phase satisfies never;
  }
}

function takingText({ targets, state, isAway, held }: StepFacts['capture']): Pick<StepBarState, 'text' | 'progress'> {
  if (state === 'waiting') return { text: 'Waiting for the camera…', progress: null };
  const done = targets.filter(({ taken }) => taken).length;
  const hint = isAway
    ? 'Go back to where you took the first photo.'
    : held > 0
      ? 'Hold still.'
      : 'Point the camera at a ring and hold still. Turn where you stand.';
  return { text: `${done} of ${targets.length} photos. ${hint}`, progress: targets.length === 0 ? 0 : done / targets.length };
}

/** Notices about the panorama, such as about what is not possible here. */
export const NOTICES = {
  noCamera: 'This device gives pages no camera image, so the light is that of a panorama file.',
  noCameraNoFile:
    'This device gives pages no camera image, so no panorama can be taken. Choose a picture of a 360° camera on the start card, or one that a phone took of this room.',
  noImage: 'The camera delivers no image, so the light is that of a panorama file. Enter again to take one of your room.',
  noImageNoFile: 'The camera delivers no image, so no panorama can be taken. Enter again, or choose a picture on the start card.',
  noMotion: 'This device has no motion sensor, so no panorama can be taken. The light is that of a panorama file.',
  noMotionNoFile: 'This device has no motion sensor, so no panorama can be taken. Choose a picture on the start card.',
  noLamp: 'The panorama has no bright lamp. Take it again.',
  holes: (percent: number) =>
    `${percent} % around you were not photographed. They are filled from their surroundings. Take the panorama again for all of them.`,
} as const;
