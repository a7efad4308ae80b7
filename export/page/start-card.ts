import { type Credit, createCredits } from './credits-list.ts';
import { element } from './dom.ts';
import { progressText } from './load-progress.ts';
import type { Ask } from './needs-text.ts';
import type { SessionMode } from './session-modes.ts';

/** What the card shows below the title: the progress of loading, the session modes, or why the page cannot be shown. */
export type StartCardState =
  | { readonly kind: 'loading'; readonly loadedBytes: number }
  /** The program is loaded and shown in the orbit view. */
  | {
      readonly kind: 'ready';
      /** Session modes to offer, best first. */
      readonly offers: readonly SessionMode[];
      /** Why the best mode is not available, in one sentence, or null. */
      readonly reason: string | null;
    }
  | { readonly kind: 'entering'; readonly mode: SessionMode }
  /** The program cannot be shown. */
  | { readonly kind: 'failed'; readonly reason: string };

export interface StartCardOptions {
  readonly document: Document;
  readonly title: string;
  readonly description: string;
  readonly asks: readonly Ask[];
  /** The controls of the page. Only their number matters here. */
  readonly controls: readonly unknown[];
  readonly credits: readonly Credit[];
  /** What the camera, VR and orbit sessions lack compared with AR, as sentences for visitors. */
  readonly lacks: Readonly<Record<'camera' | 'vr' | 'orbit', readonly string[]>>;
  /** Whether the page does no more than change the image of the camera, which needs no AR. */
  readonly isFilter: boolean;
  /** Whether the image depends on the view, so that visitors can look around. */
  readonly looksAround: boolean;
  /** Bytes to load before the first frame. */
  readonly totalBytes: number;
  readonly onEnter: (mode: SessionMode) => void;
}

export interface StartCard {
  readonly element: HTMLElement;
  show(state: StartCardState): void;
  /** Moves the focus to the first button. */
  focus(): void;
}

/** Where the card would cover the image: it begins with its title, two lines and its buttons. */
const PHONE = '(width < 480px), (height < 480px) and (pointer: coarse)';
export const TOUCH = '(pointer: coarse)';
const BY_KEYS = 'Scroll or pinch to zoom. Arrow keys work too.';

const LABELS: Readonly<Record<SessionMode, { readonly enter: string; readonly entering: string }>> = {
  ar: { enter: 'Enter AR', entering: 'Entering AR…' },
  camera: { enter: 'Use the camera', entering: 'Starting the camera…' },
  vr: { enter: 'Enter VR', entering: 'Entering VR…' },
};

/** Creates the card with the title, the description, and the session modes with what each requests and lacks. */
export function createStartCard(options: StartCardOptions): StartCard {
  const { document, title, description, totalBytes, lacks, isFilter, looksAround } = options;
  const bar = element(document, 'progress', { attributes: { max: '1', 'aria-label': 'Loading' } });
  const size = element(document, 'p', { className: 'size' });
  const loading = element(document, 'div', { className: 'loading' }, bar, size);
  const reason = element(document, 'p', { className: 'reason' });
  const ar = createModeElement(options, 'ar', arTexts(options));
  const camera = createModeElement(options, 'camera', [
    ...cameraTexts(document),
    ...lacksElement(document, [...(isFilter || !looksAround ? [] : [STANDS_STILL]), ...lacks.camera]),
  ]);
  const vr = createModeElement(options, 'vr', [...vrTexts(options), ...lacksElement(document, lacks.vr)]);
  const matches = (query: string) => document.defaultView?.matchMedia(query).matches ?? false;
  const around = element(document, 'p', { className: 'hint' }, `Drag to look around. ${matches(TOUCH) ? 'Pinch to zoom.' : BY_KEYS}`);
  const aroundLacks = element(document, 'div', {}, ...lacksElement(document, lacks.orbit));
  const body = element(
    document,
    'div',
    { id: 'panel-body' },
    loading,
    ar.element,
    camera.element,
    vr.element,
    reason,
    around,
    aroundLacks,
    ...createCredits(document, options.credits),
  );
  if (description !== '') body.prepend(element(document, 'p', { className: 'description' }, description));
  const fold = element(document, 'button', {
    className: 'fold',
    attributes: { type: 'button', 'aria-controls': 'panel-body', 'aria-label': 'About this page' },
    onClick: () => setFolded(!card.classList.contains('folded')),
  });
  const setFolded = (folded: boolean) => {
    card.classList.toggle('folded', folded);
    fold.setAttribute('aria-expanded', String(!folded));
  };
  const header = element(document, 'header', {}, element(document, 'h1', {}, title), fold);
  const modes: Readonly<Record<SessionMode, ModeElement>> = { ar, camera, vr };
  const all = Object.values(modes);
  const card = element(document, 'section', { className: 'panel', attributes: { 'aria-label': title } }, header, body);
  setFolded(matches(PHONE));
  document.defaultView?.matchMedia(PHONE).addEventListener('change', ({ matches: isPhone }) => setFolded(isPhone));
  return {
    element: card,
    show: (state) => {
      loading.hidden = state.kind !== 'loading';
      if (state.kind === 'loading') {
        // The duration is unknown before the first byte arrives.
        if (state.loadedBytes === 0) bar.removeAttribute('value');
        else bar.value = Math.min(1, state.loadedBytes / totalBytes);
        size.textContent = state.loadedBytes === 0 ? '' : progressText(state.loadedBytes, totalBytes);
      }
      const offers: readonly SessionMode[] = state.kind === 'ready' ? state.offers : [];
      const isWhole = isFilter && offers[0] === 'camera';
      const text = state.kind === 'failed' || (state.kind === 'ready' && !isWhole) ? state.reason : null;
      reason.hidden = text === null;
      reason.textContent = text ?? '';
      // Below a button it explains; alone it says why there is none.
      reason.classList.toggle('rest', offers.length > 0);
      if (state.kind === 'entering') {
        for (const mode of all) mode.setBusy(mode === modes[state.mode] ? 'entering' : 'waiting');
        return;
      }
      for (const mode of MODES) modes[mode].setOffered(offers.indexOf(mode));
      around.hidden = state.kind !== 'ready' || !looksAround;
      aroundLacks.hidden = state.kind !== 'ready' || offers.length > 0;
    },
    focus: () => {
      (all.find((mode) => !mode.element.hidden)?.button ?? fold).focus();
    },
  };
}

const MODES = ['ar', 'camera', 'vr'] as const;

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

function arTexts({ document, asks, controls }: StartCardOptions): HTMLElement[] {
  const motion = 'Your browser will ask whether this page may track how your device moves in the room.';
  const items = asks.flatMap(({ what, why }) => [element(document, 'dt', {}, what), element(document, 'dd', {}, why)]);
  return [
    element(document, 'p', {}, motion + (items.length === 0 ? '' : ' It may also use:')),
    ...(items.length === 0 ? [] : [element(document, 'dl', {}, ...items)]),
    ...(controls.length === 0 ? [] : [element(document, 'p', {}, CONTROLS_IN_ROOM)]),
    element(document, 'p', { className: 'privacy' }, PRIVACY),
  ];
}

function vrTexts({ document, controls }: StartCardOptions): HTMLElement[] {
  const asks = 'Your browser will ask whether this page may track your movement. You see a plain room instead of your own.';
  return [
    element(document, 'p', {}, asks),
    ...(controls.length === 0 ? [] : [element(document, 'p', {}, CONTROLS_IN_ROOM)]),
    element(document, 'p', { className: 'privacy' }, PRIVACY),
  ];
}

/** Text about the controls in headsets, which have no DOM overlay. */
const CONTROLS_IN_ROOM =
  'In a headset the controls are on a panel in front of you, below your eyes. Point at it and press. Values that you set here are kept.';

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
