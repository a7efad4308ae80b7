import { createControls } from './control-elements.ts';
import type { ControlValues } from './control-values.ts';
import { element } from './dom.ts';
import { createLeaveButton } from './leave-button.ts';
import { createNotices, type Notices } from './notices.ts';
import type { SessionMode } from './session-modes.ts';
import { createStartCard, type StartCard, TOUCH } from './start-card.ts';
import type { StartCardOptions } from './start-card-state.ts';

/** The elements of the page. */
export interface PageRoot {
  readonly canvas: HTMLCanvasElement;
  /** The element that AR sessions show as their DOM overlay. */
  readonly overlay: HTMLElement;
  readonly panel: StartCard;
  readonly notices: Notices;
  /** Sets the session mode that is shown; null selects the orbit view. */
  setMode(mode: SessionMode | null): void;
  /** Shows the controls, and what becomes of the poster. Call it when the first frame is drawn. */
  showCanvas(backdrop: Backdrop): void;
}

/**
 * The poster behind the orbit view: hidden, sharp in place of an image that only the room gives, or soft behind objects, which it shows,
 * too.
 */
export type Backdrop = 'gone' | 'behind' | 'behind soft';

export interface PageRootOptions extends StartCardOptions {
  readonly values: ControlValues;
  readonly onLeave: () => void;
}

/** Replaces the static content of `index.html`. Keeps the poster. */
export function createPageRoot(options: PageRootOptions): PageRoot {
  const { document, title, looksAround, onLeave } = options;
  const byTouch = document.defaultView?.matchMedia(TOUCH).matches ?? false;
  const canvas = element(document, 'canvas', {
    attributes: {
      role: 'img',
      ...(looksAround
        ? { tabindex: '0', 'aria-label': `${title}: drag ${byTouch ? '' : 'or use the arrow keys '}to look around` }
        : { 'aria-label': title }),
    },
  });
  const panel = createStartCard(options);
  const notices = createNotices(document);
  const leave = createLeaveButton(document, onLeave);
  const controls = createControls(document, options.values);
  const overlay = element(
    document,
    'div',
    { id: 'overlay' },
    notices.element,
    ...(controls ? [controls.element] : []),
    ...(leave ? [leave.element] : []),
  );
  // Prevents taps on the overlay's elements from selecting in the room (WebXR DOM Overlays §3.3). The overlay itself covers the screen.
  overlay.addEventListener('beforexrselect', (event) => {
    if (event.target !== overlay) event.preventDefault();
  });
  const poster = document.querySelector<HTMLElement>('.poster');
  document.querySelector('main')?.remove();
  const main = element(document, 'main', {}, canvas, ...(poster ? [poster] : []), panel.element, overlay);
  document.body.append(main);
  return {
    canvas,
    overlay,
    panel,
    notices,
    setMode: (mode) => {
      if (!leave?.setMode(mode)) return;
      controls?.setEntered(mode !== null);
      // An emulator that used the canvas returns it as the last child, which would cover the panel.
      if (canvas.parentElement === main && main.firstElementChild !== canvas) main.prepend(canvas);
      // The focused element is hidden now.
      if (mode === null) panel.focus();
      else leave.element.focus();
    },
    showCanvas: (backdrop) => {
      poster?.classList.add(...backdrop.split(' '));
      // The canvas is the image now.
      poster?.setAttribute('alt', '');
      controls?.setShown(true);
    },
  };
}
