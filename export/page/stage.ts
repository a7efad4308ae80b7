import type { ControlValues } from './control-values.ts';
import { createControls } from './controls.ts';
import { element } from './dom.ts';
import { createNotices, type Notices } from './notices.ts';
import { createPanel, type Panel, type PanelOptions } from './panel.ts';
import type { Way } from './way-texts.ts';

/** All that the page shows. */
export interface Stage {
  readonly canvas: HTMLCanvasElement;
  /** What a browser with DOM overlays shows above the room. */
  readonly overlay: HTMLElement;
  readonly panel: Panel;
  readonly notices: Notices;
  /** Null: looking around. */
  setWay(way: Way | null): void;
  /** The picture is there: the poster goes, and what changes the picture comes. */
  showPicture(): void;
}

export interface StageOptions extends PanelOptions {
  readonly values: ControlValues;
  readonly onLeave: () => void;
}

const LEAVE: Readonly<Record<Way, string>> = { ar: 'Leave AR', camera: 'Stop the camera', vr: 'Leave VR' };

/** Takes the place of what `index.html` shows until its script runs; the poster stays. */
export function createStage(options: StageOptions): Stage {
  const { document, title, onLeave } = options;
  const canvas = element(document, 'canvas', {
    attributes: { tabindex: '0', role: 'img', 'aria-label': `${title}: drag or use the arrow keys to look around` },
  });
  const panel = createPanel(options);
  const notices = createNotices(document);
  const leave = element(document, 'button', { className: 'leave', hidden: true, attributes: { type: 'button' }, onClick: onLeave });
  const controls = createControls(document, options.values);
  const overlay = element(document, 'div', { id: 'overlay' }, notices.element, ...(controls ? [controls.element] : []), leave);
  // A tap on what lies above the room is no tap into the room (WebXR DOM Overlays §3.3).
  overlay.addEventListener('beforexrselect', (event) => event.preventDefault());
  const poster = document.querySelector<HTMLElement>('.poster');
  document.querySelector('main')?.remove();
  document.body.append(element(document, 'main', {}, canvas, ...(poster ? [poster] : []), panel.element, overlay));
  let shown: Way | null = null;
  const stage: Stage = {
    canvas,
    overlay,
    panel,
    notices,
    setWay: (way) => {
      if (way === shown) return;
      shown = way;
      const { dataset } = document.documentElement;
      if (way === null) delete dataset.way;
      else dataset.way = way;
      leave.hidden = way === null;
      leave.textContent = way === null ? '' : LEAVE[way];
      // What had the focus is hidden now.
      if (way === null) panel.focus();
      else leave.focus();
    },
    showPicture: () => {
      poster?.classList.add('gone');
      controls?.setShown(true);
    },
  };
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && shown === 'camera') onLeave();
  });
  return stage;
}
