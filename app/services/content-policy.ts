/** The two origins of a running editor; the preview's has no host API. */
export interface Origins {
  readonly editor: string;
  readonly preview: string;
}

/**
 * Headers of everything that the content server answers.
 *
 * The editor: Monaco and React set styles at run time, hence `'unsafe-inline'` for styles alone; its workers are files of its
 * own. Neither page may speak to any other address.
 */
export function editorHeaders(origins: Origins): Record<string, string> {
  return headers([
    "default-src 'none'",
    "script-src 'self'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' blob: data:",
    "font-src 'self' data:",
    "connect-src 'self'",
    "worker-src 'self' blob:",
    `frame-src ${origins.preview}`,
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
  ]);
}

export function previewHeaders(origins: Origins): Record<string, string> {
  return headers([
    "default-src 'none'",
    // Decoders of models are WebAssembly; scripts from texts stay forbidden.
    "script-src 'self' 'wasm-unsafe-eval'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' blob: data:",
    // Videos are played from memory.
    'media-src blob:',
    "connect-src 'self'",
    "worker-src 'self' blob:",
    "base-uri 'none'",
    "form-action 'none'",
    `frame-ancestors ${origins.editor}`,
  ]);
}

/** For files of projects and recordings, which are data: opened by themselves they can do nothing. */
export function dataHeaders(): Record<string, string> {
  return { ...headers(["default-src 'none'", 'sandbox', "frame-ancestors 'none'"]), 'cache-control': 'no-store' };
}

function headers(policy: readonly string[]): Record<string, string> {
  return {
    'content-security-policy': policy.join('; '),
    'cross-origin-resource-policy': 'same-origin',
    'cross-origin-opener-policy': 'same-origin',
    'referrer-policy': 'no-referrer',
    'x-content-type-options': 'nosniff',
  };
}
