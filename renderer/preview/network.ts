/** The `fetch` of the page. The preview reads only from its own origin. */
export const pageFetch: typeof fetch = (input, init) => fetch(input, init);
