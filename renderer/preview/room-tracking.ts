import type { Emulator } from '../../export/emulator/emulator.ts';
import type { Drift } from '../../export/emulator/world.ts';

/** Faults of the emulated device's tracking by keys: drift, re-centering, lost tracking, and anchors that are lost or deleted. */
export interface RoomTracking {
  dispose(): void;
}

type Controls = Pick<Emulator, 'recenter' | 'drift' | 'setDrift' | 'setTracked' | 'setAnchors' | 'deleteAnchors'>;

/** 2 cm and 1° a minute. */
const DRIFT: Drift = { offsetM: [0.02, 0, 0], yawRad: Math.PI / 180 };

const RECENTER = 'KeyC';
const DRIFTS = 'KeyV';
const TRACKING = 'KeyK';
const LOSE_ANCHORS = 'KeyN';
const DELETE_ANCHORS = 'KeyM';
const KEYS: readonly string[] = [RECENTER, DRIFTS, TRACKING, LOSE_ANCHORS, DELETE_ANCHORS];

/** Whether the key drives the tracking. */
export function isTrackingKey({ code, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return KEYS.includes(code) && !ctrlKey && !metaKey && !altKey;
}

/**
 * Creates the keys of the tracking.
 *
 * @param hint Element that shows the keys, and what they have done.
 */
export function createRoomTracking(emulator: Controls, hint: HTMLElement): RoomTracking {
  const page = hint.ownerDocument.defaultView;
  let drifts = false;
  let isTracked = true;
  let hasAnchors = true;

  const show = () => {
    hint.textContent = [
      'C: re-center',
      drifts ? 'V: stop the drift of 2 cm and 1° a minute' : 'V: drift',
      'Shift + V: a minute of drift at once',
      isTracked ? 'K: lose tracking' : 'K: find tracking again',
      hasAnchors ? 'N: lose anchors' : 'N: find anchors again',
      'M: delete anchors',
    ].join(' · ');
  };
  const apply = ({ code, shiftKey }: KeyboardEvent) => {
    switch (code) {
      case RECENTER:
        emulator.recenter();
        break;
      case DRIFTS:
        if (shiftKey) emulator.drift(DRIFT.offsetM, DRIFT.yawRad);
        else {
          drifts = !drifts;
          emulator.setDrift(drifts ? DRIFT : null);
        }
        break;
      case TRACKING:
        isTracked = !isTracked;
        emulator.setTracked(isTracked);
        break;
      case LOSE_ANCHORS:
        hasAnchors = !hasAnchors;
        emulator.setAnchors(hasAnchors ? 'tracked' : 'lost');
        break;
      case DELETE_ANCHORS:
        emulator.deleteAnchors();
        break;
    }
    show();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (!isTrackingKey(event)) return;
    event.preventDefault();
    if (!event.repeat) apply(event);
  };

  page?.addEventListener('keydown', onKeyDown);
  show();
  hint.hidden = false;
  return {
    dispose: () => {
      page?.removeEventListener('keydown', onKeyDown);
      hint.hidden = true;
    },
  };
}
