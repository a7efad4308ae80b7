import { ICON_LINE, ICON_SIDE, ICONS, type IconName } from './icons.ts';
import { FONT_PX, type LabelLayout, LINE_HEIGHT_PX } from './layout.ts';
import type { OverlaySize } from './page-matrices.ts';
import { CORNER_PX, FONT_FAMILY, type LabelColors, TEXT_WEIGHT, TITLE_WEIGHT } from './paint-label.ts';

const SVG = 'http://www.w3.org/2000/svg';

const STYLE = `
:host { all: initial; position: absolute; inset: 0; pointer-events: none; }
.label, .leader { position: absolute; left: 0; top: 0; transform-origin: 0 0; visibility: hidden; }
.label { margin: 0; font: ${TEXT_WEIGHT} ${FONT_PX}px/${LINE_HEIGHT_PX}px ${FONT_FAMILY}; text-rendering: geometricPrecision; border-radius: ${CORNER_PX}px; }
.label.selectable { pointer-events: auto; user-select: text; -webkit-user-select: text; cursor: text; }
.label span { position: absolute; white-space: pre; user-select: inherit; -webkit-user-select: inherit; }
.label .title { font-weight: ${TITLE_WEIGHT}; }
.label svg { position: absolute; fill: none; stroke: currentColor; stroke-width: ${ICON_LINE}; stroke-linecap: round; stroke-linejoin: round; }
.leader { width: 1px; height: 1px; }
`;

/** A label as an element of the page, over the canvas. Its text is inserted as plain text: nothing in it is read as HTML. */
export interface LabelElement extends OverlaySize {
  /** Replaces the content. */
  setContent(layout: LabelLayout, icon: IconName | null, colors: LabelColors, isSelectable: boolean): void;
  /**
   * Moves the label. The matrix is a CSS `matrix3d` from label pixels to CSS pixels of the overlay. Writes no style if the matrix is the
   * same.
   */
  place(matrix: Float64Array, opacity: number): void;
  /** Moves the leader line. The matrix is a CSS `matrix` that maps a square of one pixel to the line; null hides it. */
  placeLeader(matrix: Float64Array | null, opacity: number): void;
  hide(): void;
  dispose(): void;
}

/** Adds a label to the overlay, in a shadow root, so that styles of the page do not affect the label, nor its styles the page. */
export function createLabelElement(overlay: HTMLElement): LabelElement {
  const { ownerDocument: document } = overlay;
  const host = document.createElement('div');
  const root = host.attachShadow({ mode: 'open' });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(STYLE);
  root.adoptedStyleSheets = [sheet];
  const leader = document.createElement('div');
  leader.className = 'leader';
  leader.setAttribute('aria-hidden', 'true');
  const label = document.createElement('p');
  root.append(leader, label);
  overlay.append(host);
  let widthPx = overlay.clientWidth;
  let heightPx = overlay.clientHeight;
  // Reading the size in each frame would make the browser lay the page out in each frame.
  const observer = new ResizeObserver(() => {
    widthPx = overlay.clientWidth;
    heightPx = overlay.clientHeight;
  });
  observer.observe(overlay);
  const placed = createPlaced(label, (m) => `matrix3d(${m.join()})`);
  const leading = createPlaced(leader, (m) => `matrix(${m.join()})`);
  return {
    get overlayWidthPx() {
      return widthPx;
    },
    get overlayHeightPx() {
      return heightPx;
    },
    setContent: (layout, icon, colors, isSelectable) => {
      label.className = isSelectable ? 'label selectable' : 'label';
      label.style.width = `${layout.widthPx}px`;
      label.style.height = `${layout.heightPx}px`;
      label.style.color = colors.text;
      label.style.background = colors.background;
      leader.style.background = colors.text;
      label.replaceChildren(...layout.lines.map((line) => lineElement(document, line)));
      if (icon !== null && layout.icon) label.append(iconElement(document, icon, layout.icon));
    },
    place: placed.set,
    placeLeader: (matrix, opacity) => (matrix ? leading.set(matrix, opacity) : leading.hide()),
    hide: () => {
      placed.hide();
      leading.hide();
    },
    dispose: () => {
      observer.disconnect();
      host.remove();
    },
  };
}

function lineElement(document: Document, { text, isTitle, xPx, topPx, widthPx, direction }: LabelLayout['lines'][number]): HTMLElement {
  const line = document.createElement('span');
  // The line end separates lines for screen readers and in copied text.
  line.textContent = `${text}\n`;
  line.dir = direction;
  if (isTitle) line.className = 'title';
  line.style.left = `${xPx}px`;
  line.style.top = `${topPx}px`;
  line.style.width = `${widthPx}px`;
  return line;
}

function iconElement(document: Document, icon: IconName, { xPx, yPx, sizePx }: NonNullable<LabelLayout['icon']>): SVGSVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', `0 0 ${ICON_SIDE} ${ICON_SIDE}`);
  svg.setAttribute('aria-hidden', 'true');
  svg.style.left = `${xPx}px`;
  svg.style.top = `${yPx}px`;
  svg.style.width = svg.style.height = `${sizePx}px`;
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', ICONS[icon]);
  svg.append(path);
  return svg;
}

interface Placed {
  set(matrix: Float64Array, opacity: number): void;
  hide(): void;
}

/**
 * Creates a setter of an element's transform and opacity. It writes a style only if the value has changed, because each write makes the
 * browser compute styles again.
 */
function createPlaced(element: HTMLElement, print: (matrix: Float64Array) => string): Placed {
  const last = new Float64Array(16);
  let opacityNow = 1;
  let isShown = false;
  return {
    set: (matrix, opacity) => {
      let changed = false;
      for (let i = 0; i < matrix.length; i++) {
        changed ||= last[i] !== matrix[i];
        last[i] = matrix[i] ?? 0;
      }
      if (changed) element.style.transform = print(matrix);
      if (opacity !== opacityNow) element.style.opacity = String(opacity);
      opacityNow = opacity;
      if (!isShown) element.style.visibility = 'visible';
      isShown = true;
    },
    hide: () => {
      if (isShown) element.style.visibility = 'hidden';
      isShown = false;
    },
  };
}
