/** A work of shadertoy.com as its author sees it: tabs of code, each with up to four channels. */
export interface Shadertoy {
  /** Empty where the source does not say. */
  readonly title: string;
  readonly description: string;
  readonly tags: readonly string[];
  /** Who made it, and where it is from; empty where the source does not say. */
  readonly credit: string;
  /** The last is the image; buffers come before it, in the order of their letters. */
  readonly tabs: readonly Tab[];
  /** What every tab begins with; empty where there is no such tab. */
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

/** What `iChannel0` to `iChannel3` are. Pictures of the same `key` are the same one, in whichever tab they stand. */
export type Channel =
  | { readonly kind: 'buffer'; readonly buffer: BufferLetter }
  | { readonly kind: 'picture'; readonly key: string; readonly repeat: boolean };

/** As it stands in messages. */
export function tabName({ buffer }: Pick<Tab, 'buffer'>): string {
  return buffer === null ? 'Image' : `Buffer ${buffer}`;
}
