import type { Preferences, PreferencesStore } from '../state/preferences.ts';

const LIGHT = '(prefers-color-scheme: light)';
const STILL = '(prefers-reduced-motion: reduce)';

/**
 * Puts theme and motion, chosen or the system's, and the chosen scale onto the page, and keeps them there. Styles and scripts read them
 * as `data-theme`, `data-motion` and `--ui-scale`.
 */
export function followAppearance(preferences: PreferencesStore, page: Window): () => void {
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

function show(root: HTMLElement, { theme, motion, scale }: Preferences, light: boolean, still: boolean): void {
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

/** How many client pixels one CSS pixel of an element is, whose `zoom` and that of what it is in are counted (css-viewport-1, §9). */
export function zoomOf(element: Element): number {
  return element.currentCSSZoom || 1;
}

export function uiScale(root: HTMLElement = document.documentElement): number {
  return Number(root.style.getPropertyValue('--ui-scale')) || 1;
}
