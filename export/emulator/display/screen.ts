/** The device's screen in the page: a letterboxed canvas above everything but a DOM overlay. */
export interface Screen {
  /** Size of the screen area, in device pixels. */
  sizePx(): readonly [width: number, height: number];
  show(canvas: HTMLCanvasElement, overlayRoot: HTMLElement | null): void;
  hide(): void;
}

/**
 * Creates the screen in `container`, or over the whole window if that is null. Styles are set property by property: a strict `style-src`
 * blocks style attributes and style sheets but not the object model.
 */
export function createScreen(container: HTMLElement | null): Screen {
  let shown: { readonly element: HTMLElement; restoreOverlay(): void } | null = null;
  const hide = (): void => {
    shown?.restoreOverlay();
    shown?.element.remove();
    shown = null;
  };
  return {
    sizePx: () => {
      const density = Math.min(window.devicePixelRatio, MAX_DENSITY);
      const [width, height] = container ? [container.clientWidth, container.clientHeight] : [window.innerWidth, window.innerHeight];
      return [Math.round(width * density), Math.round(height * density)];
    },
    show: (canvas, overlayRoot) => {
      hide();
      const element = document.createElement('div');
      element.dataset.scrimEmulator = '';
      setStyles(element, container ? { ...FILL, position: 'absolute' } : { ...FILL, position: 'fixed', zIndex: '2147483000' });
      // Every style is set explicitly, because pages may hide canvases by style rules.
      setStyles(canvas, { width: '100%', height: '100%', objectFit: 'contain', display: 'block', visibility: 'visible' });
      element.append(canvas);
      (container ?? document.body).append(element);
      shown = { element, restoreOverlay: overlayRoot ? setStyles(overlayRoot, OVERLAY) : () => {} };
    },
    hide,
  };
}

/** Maximum device pixels per CSS pixel. More is not visible but would be read back every frame. */
const MAX_DENSITY = 2;

const FILL = { inset: '0', background: '#000', overflow: 'hidden' } as const;

/** Styles of the DOM overlay, from the user agent style sheet of WebXR DOM Overlays §4.2. */
const OVERLAY = {
  position: 'fixed',
  inset: '0',
  zIndex: '2147483001',
  width: 'auto',
  height: 'auto',
  margin: '0',
  padding: '0',
  overflow: 'auto',
  background: 'transparent',
} as const;

/** Sets styles of an element. Returns a function that restores the previous values. */
function setStyles(element: HTMLElement, styles: Partial<Record<keyof CSSStyleDeclaration & string, string>>): () => void {
  const style = element.style as unknown as Record<string, string>;
  const former = Object.keys(styles).map((name) => [name, style[name] ?? ''] as const);
  for (const [name, value] of Object.entries(styles)) style[name] = value;
  return () => {
    for (const [name, value] of former) style[name] = value;
  };
}
