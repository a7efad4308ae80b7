import type { Credit } from './credits-list.ts';
import type { Ask } from './needs-text.ts';
import type { SessionMode } from './session-modes.ts';

/** What the card shows below the title: the progress of loading, the session modes, or why the page cannot be shown. */
export type StartCardState =
  | { readonly kind: 'loading'; readonly loadedBytes: number }
  /** The program is loaded and shown in the orbit view. */
  | {
      readonly kind: 'ready';
      /** Session modes to offer, best first. */
      readonly offers: readonly SessionMode[];
      /** Why the best mode is not available, in one sentence, or null. */
      readonly reason: string | null;
    }
  | { readonly kind: 'entering'; readonly mode: SessionMode }
  /** The program cannot be shown. */
  | { readonly kind: 'failed'; readonly reason: string };

export interface StartCardOptions {
  readonly document: Document;
  readonly title: string;
  readonly description: string;
  readonly asks: readonly Ask[];
  /** The controls of the page. Only their number matters here. */
  readonly controls: readonly unknown[];
  readonly credits: readonly Credit[];
  /** What the camera, VR and orbit sessions lack compared with AR, as sentences for visitors. */
  readonly lacks: Readonly<Record<'camera' | 'vr' | 'orbit', readonly string[]>>;
  /** Whether the page does no more than change the image of the camera, which needs no AR. */
  readonly isFilter: boolean;
  /** Whether the image depends on the view, so that visitors can look around. */
  readonly looksAround: boolean;
  /** Bytes to load before the first frame. */
  readonly totalBytes: number;
  readonly onEnter: (mode: SessionMode) => void;
}
