import { element } from './dom.ts';
import type { Ask } from './needs-text.ts';

/** What the panel shows below the title. */
export type PanelState =
  | { readonly kind: 'loading' /** 0 to 1, or null while unknown. */; readonly progress: number | null }
  | { readonly kind: 'ar' }
  | { readonly kind: 'entering' }
  /** No AR here: why, in one sentence. */
  | { readonly kind: 'view'; readonly reason: string }
  /** Nothing can be shown at all. */
  | { readonly kind: 'failed'; readonly reason: string };

export interface PanelOptions {
  readonly document: Document;
  readonly title: string;
  readonly description: string;
  readonly asks: readonly Ask[];
  readonly onEnter: () => void;
}

export interface Panel {
  readonly element: HTMLElement;
  show(state: PanelState): void;
}

/** The card with title, description and the way into AR: what will be asked for and why, before it is asked. */
export function createPanel({ document, title, description, asks, onEnter }: PanelOptions): Panel {
  const bar = element(document, 'progress', { attributes: { max: '1', 'aria-label': 'Loading' } });
  const loading = element(document, 'div', { className: 'loading' }, bar);
  const enter = element(
    document,
    'button',
    { className: 'enter', attributes: { type: 'button', 'aria-describedby': 'asks' }, onClick: onEnter },
    'Enter AR',
  );
  const ar = element(document, 'div', { className: 'ar' }, enter, asksElement(document, asks));
  const reason = element(document, 'p', { className: 'reason' });
  const hint = element(document, 'p', { className: 'hint' }, 'Drag to look around. Scroll or pinch to come closer. Arrow keys work too.');
  const body = element(document, 'div', { id: 'panel-body' }, loading, ar, reason, hint);
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
  return {
    element: element(document, 'section', { className: 'panel', attributes: { 'aria-label': title } }, header, body),
    show: (state) => {
      loading.hidden = state.kind !== 'loading';
      ar.hidden = state.kind !== 'ar' && state.kind !== 'entering';
      enter.disabled = state.kind === 'entering';
      enter.textContent = state.kind === 'entering' ? 'Entering AR…' : 'Enter AR';
      hint.hidden = state.kind !== 'ar' && state.kind !== 'view';
      reason.hidden = state.kind !== 'view' && state.kind !== 'failed';
      reason.textContent = 'reason' in state ? state.reason : '';
      if (state.kind !== 'loading') return;
      if (state.progress === null) bar.removeAttribute('value');
      else bar.value = state.progress;
    },
  };
}

function asksElement(document: Document, asks: readonly Ask[]): HTMLElement {
  const motion = 'Your browser will ask whether this page may follow how your device moves in the room.';
  const also = asks.length === 0 ? '' : ' It may also use:';
  const items = asks.flatMap(({ what, why }) => [element(document, 'dt', {}, what), element(document, 'dd', {}, why)]);
  return element(
    document,
    'div',
    { id: 'asks', className: 'asks' },
    element(document, 'p', {}, motion + also),
    ...(items.length === 0 ? [] : [element(document, 'dl', {}, ...items)]),
    element(document, 'p', { className: 'privacy' }, 'Everything stays on your device: this page sends nothing anywhere.'),
  );
}
