import { createStore, type StoreApi } from 'zustand/vanilla';
import type { RenderSize } from '../../preview-protocol.ts';

export type Theme = 'system' | 'light' | 'dark';
export type Motion = 'system' | 'reduced';
/** What scrolling over the graph does. `auto`: a mouse wheel zooms, two fingers on a trackpad pan. A pinch always zooms. */
export type Wheel = 'auto' | 'zoom' | 'pan';

/** Steps of the UI scale. */
export const SCALES = [0.8, 0.9, 1, 1.1, 1.25, 1.5] as const;

export const RENDER_SIZES: readonly RenderSize[] = ['auto', 'panel', 720, 1080, 1440];

export interface RecentProject {
  readonly path: string;
  readonly title: string;
}

/** Preferences of the user, for all projects. */
export interface Preferences {
  readonly theme: Theme;
  readonly motion: Motion;
  readonly wheel: Wheel;
  /** UI scale, one of `SCALES`. */
  readonly scale: number;
  /** Whether nodes show thumbnails of their layers. */
  readonly thumbnails: boolean;
  /** Size in which the preview renders. */
  readonly renderSize: RenderSize;
  /** Keybindings that differ from the defaults, by command. An empty list removes the default. */
  readonly keybindings: Readonly<Record<string, readonly string[]>>;
  /** Recent projects, newest first. */
  readonly recent: readonly RecentProject[];
  /** Favorite node types of the palette, in the order in which they were chosen. */
  readonly favorites: readonly string[];
  /** Node types that were added last, newest first. */
  readonly recentTypes: readonly string[];
  /** Paths of programs of others as they were typed; empty: those of the host. */
  readonly colmap: string;
  readonly blender: string;
  readonly instantMeshes: string;
}

/** A preference that is the path of a program. */
export type ProgramPath = 'colmap' | 'blender' | 'instantMeshes';

export type PreferencesStore = StoreApi<Preferences>;

/** The part of the editor that these functions need. */
type PreferencesHolder = { readonly preferences: PreferencesStore };

export const DEFAULT_PREFERENCES: Preferences = {
  theme: 'system',
  motion: 'system',
  wheel: 'auto',
  scale: 1,
  thumbnails: true,
  renderSize: 'auto',
  keybindings: {},
  recent: [],
  favorites: [],
  recentTypes: [],
  colmap: '',
  blender: '',
  instantMeshes: '',
};

const KEY = 'scrim-preferences';

/** Stored format. `chords` is the stored name of `keybindings`. */
type StoredPreferences = Omit<Preferences, 'keybindings'> & { readonly chords: Preferences['keybindings'] };
const MAX_RECENT = 8;
const MAX_RECENT_TYPES = 5;
const MAX_FAVORITES = 100;

export function createPreferences(preferences: Preferences): PreferencesStore {
  return createStore<Preferences>(() => preferences);
}

/** Reads the stored preferences. Missing or invalid values become defaults. */
export function loadPreferences(storage: Pick<Storage, 'getItem'>): Preferences {
  let saved: Partial<Record<keyof StoredPreferences, unknown>> = {};
  try {
    saved = (JSON.parse(storage.getItem(KEY) ?? '{}') ?? {}) as typeof saved;
  } catch {
    // Invalid JSON: use the defaults.
  }
  return {
    theme: saved.theme === 'light' || saved.theme === 'dark' ? saved.theme : 'system',
    motion: saved.motion === 'reduced' ? 'reduced' : 'system',
    wheel: saved.wheel === 'zoom' || saved.wheel === 'pan' ? saved.wheel : 'auto',
    scale: SCALES.find((scale) => scale === saved.scale) ?? 1,
    thumbnails: saved.thumbnails !== false,
    renderSize: RENDER_SIZES.find((size) => size === saved.renderSize) ?? 'auto',
    keybindings: readKeybindings(saved.chords),
    recent: Array.isArray(saved.recent) ? saved.recent.filter(isRecent).slice(0, MAX_RECENT) : [],
    favorites: readTypes(saved.favorites, MAX_FAVORITES),
    recentTypes: readTypes(saved.recentTypes, MAX_RECENT_TYPES),
    colmap: readText(saved.colmap),
    blender: readText(saved.blender),
    instantMeshes: readText(saved.instantMeshes),
  };
}

function readText(saved: unknown): string {
  return typeof saved === 'string' ? saved : '';
}

/** Stores each change at once, so that the next window reads it. */
export function keepPreferences({ preferences }: PreferencesHolder, storage: Pick<Storage, 'setItem'>): () => void {
  return preferences.subscribe(({ keybindings: chords, ...rest }) => {
    const stored: StoredPreferences = { ...rest, chords };
    storage.setItem(KEY, JSON.stringify(stored));
  });
}

export function rememberProject({ preferences }: PreferencesHolder, project: RecentProject): void {
  preferences.setState(({ recent }) => ({
    recent: [project, ...recent.filter(({ path }) => path !== project.path)].slice(0, MAX_RECENT),
  }));
}

export function forgetProject({ preferences }: PreferencesHolder, path: string): void {
  preferences.setState(({ recent }) => ({ recent: recent.filter((project) => project.path !== path) }));
}

/** Adds a node type to the favorites of the palette, or removes it. */
export function toggleFavorite({ preferences }: PreferencesHolder, type: string): void {
  preferences.setState(({ favorites }) => ({
    favorites: favorites.includes(type) ? favorites.filter((other) => other !== type) : [...favorites, type].slice(-MAX_FAVORITES),
  }));
}

export function rememberType({ preferences }: PreferencesHolder, type: string): void {
  preferences.setState(({ recentTypes }) => ({
    recentTypes: [type, ...recentTypes.filter((other) => other !== type)].slice(0, MAX_RECENT_TYPES),
  }));
}

function readTypes(value: unknown, most: number): readonly string[] {
  return Array.isArray(value) ? value.filter((type) => typeof type === 'string').slice(0, most) : [];
}

function isRecent(value: unknown): value is RecentProject {
  const project = value as Partial<RecentProject> | null;
  return typeof project?.path === 'string' && typeof project.title === 'string';
}

function readKeybindings(value: unknown): Record<string, readonly string[]> {
  if (typeof value !== 'object' || value === null) return {};
  const isList = (keybindings: unknown): keybindings is readonly string[] =>
    Array.isArray(keybindings) && keybindings.every((keybinding) => typeof keybinding === 'string');
  return Object.fromEntries(Object.entries(value).filter((entry): entry is [string, readonly string[]] => isList(entry[1])));
}
