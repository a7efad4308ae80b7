import { controlTexts } from './control-texts.ts';
import { element } from './dom.ts';
import type { SessionMode } from './session-modes.ts';
import type { StartCardOptions, StartCardState } from './start-card-state.ts';

/** The elements of the start card that belong to session modes. A page whose program plays in none does without. */
export interface ModeElements {
  /** A button for each mode, with what it requests and lacks. */
  readonly elements: readonly HTMLElement[];
  /** What the orbit view lacks. */
  readonly lacks: readonly HTMLElement[];
  show(state: StartCardState): void;
  /** The first button that is visible; null if there is none. */
  firstButton(): HTMLElement | null;
}

const LABELS: Readonly<Record<SessionMode, { readonly enter: string; readonly entering: string }>> = {
  ar: { enter: 'Enter AR', entering: 'Entering AR…' },
  camera: { enter: 'Use the camera', entering: 'Starting the camera…' },
  vr: { enter: 'Enter VR', entering: 'Entering VR…' },
};

const MODES = ['ar', 'camera', 'vr'] as const;

export function createModeElements(options: StartCardOptions): ModeElements {
  const { document, lacks, isFilter, looksAround } = options;
  const ar = createModeElement(options, 'ar', arTexts(options));
  const camera = createModeElement(options, 'camera', [
    ...cameraTexts(document),
    ...lacksElement(document, [...(isFilter || !looksAround ? [] : [STANDS_STILL]), ...lacks.camera]),
  ]);
  const vr = createModeElement(options, 'vr', [...vrTexts(options), ...lacksElement(document, lacks.vr)]);
  const orbitLacks = element(document, 'div', {}, ...lacksElement(document, lacks.orbit));
  const modes: Readonly<Record<SessionMode, ModeElement>> = { ar, camera, vr };
  const all = Object.values(modes);
  return {
    elements: all.map((mode) => mode.element),
    lacks: [orbitLacks],
    show: (state) => {
      if (state.kind === 'entering') {
        for (const mode of all) mode.setBusy(mode === modes[state.mode] ? 'entering' : 'waiting');
        return;
      }
      const offers: readonly SessionMode[] = state.kind === 'ready' ? state.offers : [];
      for (const mode of MODES) modes[mode].setOffered(offers.indexOf(mode));
      orbitLacks.hidden = state.kind !== 'ready' || offers.length > 0;
    },
    firstButton: () => all.find((mode) => !mode.element.hidden)?.button ?? null,
  };
}

interface ModeElement {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  /** Sets the position of the mode among the offered modes; −1 hides the mode. */
  setOffered(place: number): void;
  setBusy(state: 'entering' | 'waiting'): void;
}

function createModeElement({ document, onEnter }: StartCardOptions, mode: SessionMode, texts: readonly HTMLElement[]): ModeElement {
  const { enter, entering } = LABELS[mode];
  const id = `about-${mode}`;
  const button = element(
    document,
    'button',
    { className: 'enter', attributes: { type: 'button', 'aria-describedby': id }, onClick: () => onEnter(mode) },
    enter,
  );
  const about = element(document, 'div', { id, className: 'asks' }, ...texts);
  const made = element(document, 'div', { hidden: true }, button, about);
  return {
    element: made,
    button,
    setOffered: (place) => {
      made.hidden = place < 0;
      button.className = place > 0 ? 'enter second' : 'enter';
      button.disabled = false;
      button.textContent = enter;
    },
    setBusy: (state) => {
      button.disabled = true;
      if (state === 'entering') button.textContent = entering;
    },
  };
}

const PRIVACY = 'Everything stays on your device. This page sends no data.';

function arTexts({ document, asks }: StartCardOptions): HTMLElement[] {
  const motion = 'Your browser will ask whether this page may track how your device moves in the room.';
  const items = asks.flatMap(({ what, why }) => [element(document, 'dt', {}, what), element(document, 'dd', {}, why)]);
  return [
    element(document, 'p', {}, motion + (items.length === 0 ? '' : ' It may also use:')),
    ...(items.length === 0 ? [] : [element(document, 'dl', {}, ...items)]),
    ...controlTexts(document),
    element(document, 'p', { className: 'privacy' }, PRIVACY),
  ];
}

function vrTexts({ document }: StartCardOptions): HTMLElement[] {
  const asks = 'Your browser will ask whether this page may track your movement. You see a plain room instead of your own.';
  return [element(document, 'p', {}, asks), ...controlTexts(document), element(document, 'p', { className: 'privacy' }, PRIVACY)];
}

function cameraTexts(document: Document): HTMLElement[] {
  const asks = 'Your browser will ask for the camera, and perhaps for motion sensors.';
  return [element(document, 'p', {}, asks), element(document, 'p', { className: 'privacy' }, PRIVACY)];
}

/** What a camera session lacks in any case, because the position of the device is not measured. */
const STANDS_STILL = 'Objects keep their direction as you turn, but do not stay in place as you walk.';

function lacksElement(document: Document, lacks: readonly string[]): HTMLElement[] {
  if (lacks.length === 0) return [];
  const items = lacks.map((text) => element(document, 'li', {}, text));
  return [
    element(
      document,
      'details',
      { className: 'lacks' },
      element(document, 'summary', {}, 'Missing compared with AR'),
      element(document, 'ul', {}, ...items),
    ),
  ];
}
