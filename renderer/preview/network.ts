/** The page's own `fetch`: everything it reads lies on its own origin. */
export const pageFetch: typeof fetch = (input, init) => fetch(input, init);
