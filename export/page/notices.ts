import { type Diagnostic, type DiagnosticCode, hasErrors } from '../../nodes/kit/diagnostics.ts';
import { element } from './dom.ts';

export interface Notice {
  readonly text: string;
  /** Urgency of the notice. Screen readers announce a `problem` immediately and a `hint` when they are idle. */
  readonly tone: 'problem' | 'hint';
  /** A button after the text. */
  readonly action?: HTMLElement;
}

/** Short messages above the page, one per topic: a new message replaces the previous one of its topic. */
export interface Notices {
  readonly element: HTMLElement;
  show(topic: string, notice: Notice): void;
  clear(topic: string): void;
}

export function createNotices(document: Document): Notices {
  // Both regions exist from the start, because screen readers announce only changes in existing live regions.
  const problems = element(document, 'div', { attributes: { role: 'alert' } });
  const hints = element(document, 'div', { attributes: { role: 'status' } });
  const shown = new Map<string, HTMLElement>();
  const clear = (topic: string) => {
    shown.get(topic)?.remove();
    shown.delete(topic);
  };
  return {
    element: element(document, 'div', { className: 'notices' }, problems, hints),
    show: (topic, { text, tone, action }) => {
      if (shown.get(topic)?.dataset.text === text) return;
      clear(topic);
      const dismiss = element(document, 'button', {
        className: 'dismiss',
        attributes: { type: 'button', 'aria-label': 'Dismiss' },
        onClick: () => clear(topic),
      });
      const notice = element(
        document,
        'div',
        { className: `notice ${tone}` },
        element(document, 'p', {}, text),
        ...(action ? [action] : []),
        dismiss,
      );
      notice.dataset.text = text;
      shown.set(topic, notice);
      (tone === 'problem' ? problems : hints).append(notice);
    },
    clear,
  };
}

/** Shows the diagnostics of a topic as one notice with remedies for visitors. */
export function showDiagnostics(notices: Notices, topic: string, diagnostics: readonly Diagnostic[]): void {
  const texts = diagnostics.map(visitorText);
  if (texts.length === 0) notices.clear(topic);
  else notices.show(topic, { text: [...new Set(texts)].join(' '), tone: hasErrors(diagnostics) ? 'problem' : 'hint' });
}

/**
 * The text of a diagnostic for visitors. Remedies (`fix`) are written for designers, so most are replaced by one for visitors or left out.
 */
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
