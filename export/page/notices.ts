import { type Diagnostic, type DiagnosticCode, hasErrors } from '../../nodes/kit/diagnostics.ts';
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

/** One notice for all of a topic: what is wrong, and what a visitor can do about it. */
export function showDiagnostics(notices: Notices, topic: string, diagnostics: readonly Diagnostic[]): void {
  const texts = diagnostics.map(visitorText);
  if (texts.length === 0) notices.clear(topic);
  else notices.show(topic, { text: [...new Set(texts)].join(' '), tone: hasErrors(diagnostics) ? 'problem' : 'hint' });
}

/** What is wrong with a project is said to designers, and its remedy means nothing to visitors. */
function visitorText({ code, message, fix }: Diagnostic): string {
  const remedy = VISITOR_REMEDIES[code];
  if (remedy === 'its own') return fix === undefined ? message : `${message} ${fix}`;
  return remedy === undefined ? message : `${message} ${remedy}`;
}

const VISITOR_REMEDIES: Readonly<Partial<Record<DiagnosticCode, string>>> = {
  SCR030: 'Check the connection, then reload the page.',
  SCR032: 'It may have been damaged during loading. Reload the page.',
  SCR050: 'its own',
  SCR051: 'its own',
};
