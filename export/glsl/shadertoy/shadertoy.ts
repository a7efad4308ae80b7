/** A work of shadertoy.com: tabs of code with up to four channels each. */
export interface Shadertoy {
  /** Empty if the source has none. */
  readonly title: string;
  readonly description: string;
  readonly tags: readonly string[];
  /** Author and address; empty if the source has none. */
  readonly credit: string;
  /** Buffers in the order of their letters, then the image. */
  readonly tabs: readonly Tab[];
  /** Text of the tab *Common*, which precedes the text of every other tab; empty without such a tab. */
  readonly common: string;
}

export interface Tab {
  readonly buffer: BufferLetter | null;
  readonly code: string;
  readonly channels: readonly Channel[];
}

export type BufferLetter = 'A' | 'B' | 'C' | 'D';

export const BUFFER_LETTERS: readonly BufferLetter[] = ['A', 'B', 'C', 'D'];

export const CHANNEL_COUNT = 4;

/** Content of `iChannel0` to `iChannel3`. Images with equal `key` are the same in all tabs. */
export type Channel =
  | { readonly kind: 'buffer'; readonly buffer: BufferLetter }
  | { readonly kind: 'picture'; readonly key: string; readonly repeat: boolean };

/** Name of the tab in messages. */
export function tabName({ buffer }: Pick<Tab, 'buffer'>): string {
  return buffer === null ? 'Image' : `Buffer ${buffer}`;
}
