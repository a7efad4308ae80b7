import { type Credit, createCredits } from './credits.ts';
import { element } from './dom.ts';
import { progressText } from './load-progress.ts';
import type { Ask } from './needs-text.ts';
import type { Way } from './way-texts.ts';

/** What the panel shows below the title. */
export type PanelState =
  | { readonly kind: 'loading'; readonly loadedBytes: number }
  /** Shown, to be looked around. */
  | {
      readonly kind: 'ready';
      /** What can be entered from here, best first. */
      readonly offers: readonly Way[];
      /** Why the best way cannot be had, in one sentence, or null. */
      readonly reason: string | null;
    }
  | { readonly kind: 'entering'; readonly way: Way }
  /** Nothing can be shown at all. */
  | { readonly kind: 'failed'; readonly reason: string };

export interface PanelOptions {
  readonly document: Document;
  readonly title: string;
  readonly description: string;
  readonly asks: readonly Ask[];
  /** What visitors can set. */
  readonly controls: readonly unknown[];
  readonly credits: readonly Credit[];
  /** What the picture does without what the camera, VR or looking around lacks. */
  readonly lacks: Readonly<Record<'camera' | 'vr' | 'orbit', readonly string[]>>;
  /** Of all that has to be loaded. */
  readonly totalBytes: number;
  readonly onEnter: (way: Way) => void;
}

export interface Panel {
  readonly element: HTMLElement;
  show(state: PanelState): void;
  /** To where the visitor came from. */
  focus(): void;
}

const LABELS: Readonly<Record<Way, { readonly enter: string; readonly entering: string }>> = {
  ar: { enter: 'Enter AR', entering: 'Entering AR…' },
  camera: { enter: 'Use the camera', entering: 'Starting the camera…' },
  vr: { enter: 'Enter VR', entering: 'Entering VR…' },
};

/** The card with title, description and the ways in: what each will ask for, and what it lacks, before it is asked. */
export function createPanel(options: PanelOptions): Panel {
  const { document, title, description, totalBytes, lacks } = options;
  const bar = element(document, 'progress', { attributes: { max: '1', 'aria-label': 'Loading' } });
  const size = element(document, 'p', { className: 'size' });
  const loading = element(document, 'div', { className: 'loading' }, bar, size);
  const reason = element(document, 'p', { className: 'reason' });
  const ar = createWay(options, 'ar', arTexts(options));
  const camera = createWay(options, 'camera', [...cameraTexts(document), ...lacksElement(document, [STANDS_STILL, ...lacks.camera])]);
  const vr = createWay(options, 'vr', [...vrTexts(options), ...lacksElement(document, lacks.vr)]);
  const around = element(
    document,
    'div',
    {},
    element(document, 'p', { className: 'hint' }, 'Drag to look around. Scroll or pinch to come closer. Arrow keys work too.'),
  );
  const aroundLacks = element(document, 'div', {}, ...lacksElement(document, lacks.orbit));
  const body = element(
    document,
    'div',
    { id: 'panel-body' },
    loading,
    reason,
    ar.element,
    camera.element,
    vr.element,
    around,
    aroundLacks,
    ...createCredits(document, options.credits),
  );
  if (description !== '') body.prepend(element(document, 'p', { className: 'description' }, description));
  const fold = element(document, 'button', {
    className: 'fold',
    attributes: { type: 'button', 'aria-expanded': 'true', 'aria-controls': 'panel-body', 'aria-label': 'About this page' },
    onClick: () => {
      body.hidden = !body.hidden;
      fold.setAttribute('aria-expanded', String(!body.hidden));
    },
  });
  const header = element(document, 'header', {}, element(document, 'h1', {}, title), fold);
  const ways: Readonly<Record<Way, WayElement>> = { ar, camera, vr };
  const all = Object.values(ways);
  return {
    element: element(document, 'section', { className: 'panel', attributes: { 'aria-label': title } }, header, body),
    show: (state) => {
      loading.hidden = state.kind !== 'loading';
      if (state.kind === 'loading') {
        // Before the first byte is here, nobody knows how long it takes.
        if (state.loadedBytes === 0) bar.removeAttribute('value');
        else bar.value = Math.min(1, state.loadedBytes / totalBytes);
        size.textContent = state.loadedBytes === 0 ? '' : progressText(state.loadedBytes, totalBytes);
      }
      const text = state.kind === 'ready' || state.kind === 'failed' ? state.reason : null;
      reason.hidden = text === null;
      reason.textContent = text ?? '';
      if (state.kind === 'entering') {
        for (const way of all) way.setBusy(way === ways[state.way] ? 'entering' : 'waiting');
        return;
      }
      const offers: readonly Way[] = state.kind === 'ready' ? state.offers : [];
      for (const way of WAYS) ways[way].setOffered(offers.indexOf(way));
      around.hidden = state.kind !== 'ready';
      aroundLacks.hidden = state.kind !== 'ready' || offers.length > 0;
    },
    focus: () => {
      (all.find((way) => !way.element.hidden)?.button ?? fold).focus();
    },
  };
}

const WAYS = ['ar', 'camera', 'vr'] as const;

interface WayElement {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  /** The place among what is offered; -1: not at all. */
  setOffered(place: number): void;
  setBusy(state: 'entering' | 'waiting'): void;
}

function createWay({ document, onEnter }: PanelOptions, way: Way, texts: readonly HTMLElement[]): WayElement {
  const { enter, entering } = LABELS[way];
  const id = `about-${way}`;
  const button = element(
    document,
    'button',
    { className: 'enter', attributes: { type: 'button', 'aria-describedby': id }, onClick: () => onEnter(way) },
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

const PRIVACY = 'Everything stays on your device: this page sends nothing anywhere.';

function arTexts({ document, asks, controls }: PanelOptions): HTMLElement[] {
  const motion = 'Your browser will ask whether this page may follow how your device moves in the room.';
  const items = asks.flatMap(({ what, why }) => [element(document, 'dt', {}, what), element(document, 'dd', {}, why)]);
  return [
    element(document, 'p', {}, motion + (items.length === 0 ? '' : ' It may also use:')),
    ...(items.length === 0 ? [] : [element(document, 'dl', {}, ...items)]),
    ...(controls.length === 0 ? [] : [element(document, 'p', {}, CONTROLS_IN_ROOM)]),
    element(document, 'p', { className: 'privacy' }, PRIVACY),
  ];
}

function vrTexts({ document, controls }: PanelOptions): HTMLElement[] {
  const asks = 'Your browser will ask whether this page may follow how you move. A plain room stands in for your own.';
  return [
    element(document, 'p', {}, asks),
    ...(controls.length === 0 ? [] : [element(document, 'p', {}, CONTROLS_IN_ROOM)]),
    element(document, 'p', { className: 'privacy' }, PRIVACY),
  ];
}

/** They have no DOM overlays. */
const CONTROLS_IN_ROOM =
  'In a headset the controls are on a panel in front of you, below your eyes: point at it and press. What you set here before stays set.';

function cameraTexts(document: Document): HTMLElement[] {
  const asks = 'Your browser will ask for the camera, and perhaps whether this page may follow how your device turns.';
  return [element(document, 'p', {}, asks), element(document, 'p', { className: 'privacy' }, PRIVACY)];
}

/** No sensor tells how a device moves. */
const STANDS_STILL = 'Things keep their direction as you turn, but cannot stay in place as you walk.';

function lacksElement(document: Document, lacks: readonly string[]): HTMLElement[] {
  if (lacks.length === 0) return [];
  const items = lacks.map((text) => element(document, 'li', {}, text));
  return [
    element(
      document,
      'details',
      { className: 'lacks' },
      element(document, 'summary', {}, 'What is missing compared with AR'),
      element(document, 'ul', {}, ...items),
    ),
  ];
}
