import { createCredits } from './credits-list.ts';
import { element } from './dom.ts';
import { progressText } from './load-progress.ts';
import { createModeElements } from './mode-elements.ts';
import type { SessionMode } from './session-modes.ts';
import type { StartCardOptions, StartCardState } from './start-card-state.ts';

export interface StartCard {
  readonly element: HTMLElement;
  show(state: StartCardState): void;
  /** Moves the focus to the first button. */
  focus(): void;
}

/** Where the card would cover the image: it begins with its title, two lines and its buttons. */
export const PHONE = '(width < 480px), (height < 480px) and (pointer: coarse)';
export const TOUCH = '(pointer: coarse)';
const BY_KEYS = 'Scroll or pinch to zoom. Arrow keys work too.';

/** Creates the card with the title, the description, and the session modes with what each requests and lacks. */
export function createStartCard(options: StartCardOptions): StartCard {
  const { document, title, description, totalBytes, isFilter, looksAround } = options;
  const bar = element(document, 'progress', { attributes: { max: '1', 'aria-label': 'Loading' } });
  const size = element(document, 'p', { className: 'size' });
  const loading = element(document, 'div', { className: 'loading' }, bar, size);
  const reason = element(document, 'p', { className: 'reason' });
  const modes = createModeElements(options);
  const matches = (query: string) => document.defaultView?.matchMedia(query).matches ?? false;
  const around = element(document, 'p', { className: 'hint' }, `Drag to look around. ${matches(TOUCH) ? 'Pinch to zoom.' : BY_KEYS}`);
  const body = element(
    document,
    'div',
    { id: 'panel-body' },
    loading,
    ...modes.elements,
    reason,
    around,
    ...modes.lacks,
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
      modes.show(state);
      if (state.kind !== 'entering') around.hidden = state.kind !== 'ready' || !looksAround;
    },
    focus: () => {
      (modes.firstButton() ?? fold).focus();
    },
  };
}
