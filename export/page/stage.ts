import { element } from './dom.ts';
import type { Ask } from './needs-text.ts';
import { createNotices, type Notices } from './notices.ts';
import { createPanel, type Panel } from './panel.ts';

/** All that the page shows. */
export interface Stage {
  readonly canvas: HTMLCanvasElement;
  /** What a browser with DOM overlays shows above the room. */
  readonly overlay: HTMLElement;
  readonly panel: Panel;
  readonly notices: Notices;
  setInAr(inAr: boolean): void;
}

export interface StageOptions {
  readonly document: Document;
  readonly title: string;
  readonly description: string;
  readonly asks: readonly Ask[];
  readonly onEnter: () => void;
  readonly onLeave: () => void;
}

export function createStage({ document, title, description, asks, onEnter, onLeave }: StageOptions): Stage {
  const canvas = element(document, 'canvas', {
    attributes: { tabindex: '0', role: 'img', 'aria-label': `${title}: drag or use the arrow keys to look around` },
  });
  const panel = createPanel({ document, title, description, asks, onEnter });
  const notices = createNotices(document);
  const leave = element(
    document,
    'button',
    { className: 'leave', hidden: true, attributes: { type: 'button' }, onClick: onLeave },
    'Leave AR',
  );
  const overlay = element(document, 'div', { id: 'overlay' }, notices.element, leave);
  document.body.append(element(document, 'main', {}, canvas, panel.element, overlay));
  return {
    canvas,
    overlay,
    panel,
    notices,
    setInAr: (inAr) => {
      document.documentElement.classList.toggle('in-ar', inAr);
      leave.hidden = !inAr;
    },
  };
}
