/** Permissions that the content security policy must give besides loading the page's own files. */
export interface PagePowers {
  /** Whether the page may compile WebAssembly, which all model decoders use. */
  readonly wasm: boolean;
  /** Whether the page may start workers from blobs, which most model decoders, HDR and EXR panoramas and all CPU filters use. */
  readonly workers: boolean;
  /** Whether the page may play videos from blobs. */
  readonly media: boolean;
}

/** Source of the page's script and style: files beside the page, or inline with the hashes of their texts (`sha256-…`). */
export type PageOrigin = { readonly kind: 'files' } | { readonly kind: 'single'; readonly scriptHash: string; readonly styleHash: string };

/**
 * The content security policy of the page: it allows only files beside the page or in it. Images may also be `data:` URLs (the empty icon
 * and the poster of a single-file page). A page of several files may have a service worker.
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
