/** `fetch` for the page's own files; the content security policy blocks all others. */
export function browserFetch(): typeof fetch {
  return fetch.bind(globalThis);
}
