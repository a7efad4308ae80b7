import { element } from './dom.ts';

export interface Notice {
  readonly text: string;
  /** `problem` is read out at once, `hint` when the visitor pauses. */
  readonly tone: 'problem' | 'hint';
}

/** Short messages above everything else, one per topic: a new one of the same topic replaces the old. */
export interface Notices {
  readonly element: HTMLElement;
  show(topic: string, notice: Notice): void;
  clear(topic: string): void;
}

export function createNotices(document: Document): Notices {
  // Both regions exist from the start: screen readers announce only changes inside regions they know.
  const problems = element(document, 'div', { attributes: { role: 'alert' } });
  const hints = element(document, 'div', { attributes: { role: 'status' } });
  const shown = new Map<string, HTMLElement>();
  const clear = (topic: string) => {
    shown.get(topic)?.remove();
    shown.delete(topic);
  };
  return {
    element: element(document, 'div', { className: 'notices' }, problems, hints),
    show: (topic, { text, tone }) => {
      if (shown.get(topic)?.dataset.text === text) return;
      clear(topic);
      const dismiss = element(document, 'button', {
        className: 'dismiss',
        attributes: { type: 'button', 'aria-label': 'Dismiss' },
        onClick: () => clear(topic),
      });
      const notice = element(document, 'div', { className: `notice ${tone}` }, element(document, 'p', {}, text), dismiss);
      notice.dataset.text = text;
      shown.set(topic, notice);
      (tone === 'problem' ? problems : hints).append(notice);
    },
    clear,
  };
}
