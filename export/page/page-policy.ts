/** What of the browser, beyond showing files that lie beside it, the page needs. */
export interface PagePowers {
  /** Compiling WebAssembly: every decoder of models is made of it. */
  readonly wasm: boolean;
  /** Workers that are made from text: most decoders work in one, and CPU filters in one each. */
  readonly workers: boolean;
  /** Videos, played from bytes. */
  readonly media: boolean;
}

/** Where a page's script and style come from: files beside it, or itself, by the hashes of their texts (`sha256-…`). */
export type PageOrigin = { readonly kind: 'files' } | { readonly kind: 'single'; readonly scriptHash: string; readonly styleHash: string };

/**
 * The page's content security policy: only what lies beside the page, or in it. Pictures may also be data (the empty icon, and the
 * poster of a page in one file); a page of several files may have a service worker.
 */
export function pagePolicy(origin: PageOrigin, { wasm, workers, media }: PagePowers): string {
  const single = origin.kind === 'single';
  const script = single ? `'${origin.scriptHash}'` : "'self'";
  const workerSources = [...(single ? [] : ["'self'"]), ...(workers ? ['blob:'] : [])];
  return [
    "default-src 'none'",
    `script-src ${script}${wasm ? " 'wasm-unsafe-eval'" : ''}`,
    `style-src ${single ? `'${origin.styleHash}'` : "'self'"}`,
    `img-src ${single ? 'data:' : "'self' data:"}`,
    ...(single ? [] : ["connect-src 'self'"]),
    ...(workerSources.length === 0 ? [] : [`worker-src ${workerSources.join(' ')}`]),
    ...(media ? [`media-src ${single ? 'blob:' : "'self' blob:"}`] : []),
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}
