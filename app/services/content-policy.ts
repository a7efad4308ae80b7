/** The two origins of a running editor; the preview's has no host API. */
export interface Origins {
  readonly editor: string;
  readonly preview: string;
}

/** Where the built pages have their scripts; projects and recordings are never mounted there. */
export const SCRIPTS_FOLDER = 'assets';

/**
 * Headers of everything that the content server answers.
 *
 * The editor: Monaco and React set styles at run time, hence `'unsafe-inline'` for styles alone; its workers are files of its
 * own. Neither page may speak to any other address.
 */
export function editorHeaders(origins: Origins): Record<string, string> {
  const ownScripts = `${origins.editor}/${SCRIPTS_FOLDER}/`;
  return headers([
    "default-src 'none'",
    `script-src ${ownScripts}`,
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' blob: data:",
    "font-src 'self' data:",
    "connect-src 'self'",
    `worker-src ${ownScripts} blob:`,
    `frame-src ${origins.preview}`,
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
  ]);
}

export function previewHeaders(origins: Origins): Record<string, string> {
  // The path as well: projects and recordings are on this origin, and nothing of them is a script, whatever its name and type.
  const ownScripts = `${origins.preview}/${SCRIPTS_FOLDER}/`;
  return headers([
    "default-src 'none'",
    // Decoders of models are WebAssembly; scripts from texts stay forbidden.
    `script-src ${ownScripts} 'wasm-unsafe-eval'`,
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' blob: data:",
    // Videos are played from memory.
    'media-src blob:',
    "connect-src 'self'",
    `worker-src ${ownScripts} blob:`,
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
