const LIGHT = '(prefers-color-scheme: light)';
const STILL = '(prefers-reduced-motion: reduce)';

/** Settings of the appearance. */
export interface Appearance {
  readonly theme: 'system' | 'light' | 'dark';
  readonly motion: 'system' | 'reduced';
  /** UI scale, a factor on the size of text and controls. */
  readonly scale: number;
}

/** Observable store of the appearance settings. */
export interface AppearanceStore {
  getState(): Appearance;
  subscribe(onChange: () => void): () => void;
}

/**
 * Applies theme, motion and UI scale to the page as `data-theme`, `data-motion` and `--ui-scale`, and follows changes of the settings and
 * of the system.
 *
 * @returns A function that stops following.
 */
export function followAppearance(preferences: AppearanceStore, page: Window): () => void {
  const light = page.matchMedia(LIGHT);
  const still = page.matchMedia(STILL);
  const apply = () => show(page.document.documentElement, preferences.getState(), light.matches, still.matches);
  apply();
  const stop = preferences.subscribe(apply);
  for (const query of [light, still]) query.addEventListener('change', apply);
  return () => {
    stop();
    for (const query of [light, still]) query.removeEventListener('change', apply);
  };
}

function show(root: HTMLElement, { theme, motion, scale }: Appearance, light: boolean, still: boolean): void {
  root.dataset.theme = theme === 'system' ? (light ? 'light' : 'dark') : theme;
  root.style.setProperty('--ui-scale', String(scale));
  root.dataset.motion = motion === 'reduced' || still ? 'reduced' : 'full';
}

export function isLight(root: HTMLElement = document.documentElement): boolean {
  return root.dataset.theme === 'light';
}

export function isStill(root: HTMLElement = document.documentElement): boolean {
  return root.dataset.motion === 'reduced';
}

/** Client pixels per CSS pixel of an element: the product of its `zoom` and that of its ancestors (css-viewport-1, §9). */
export function zoomOf(element: Element): number {
  return element.currentCSSZoom || 1;
}

export function uiScale(root: HTMLElement = document.documentElement): number {
  return Number(root.style.getPropertyValue('--ui-scale')) || 1;
}
