/** The page's way to its own files; its policy allows no others. */
export function browserFetch(): typeof fetch {
  return fetch.bind(globalThis);
}
