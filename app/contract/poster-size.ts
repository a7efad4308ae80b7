/** Of the picture that an export takes along: what those who show links expect, and what `export/bundle` draws. */
export const POSTER_SIZE = { widthPx: 1200, heightPx: 630 } as const;
