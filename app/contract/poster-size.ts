/** Size of the poster of an exported page, as link previews expect it. */
export const POSTER_SIZE = { widthPx: 1200, heightPx: 630 } as const;
