/** The two origins of a running editor. That of the preview has no host API. */
export interface Origins {
  readonly editor: string;
  readonly preview: string;
}

/** Folder of scripts in the built pages. Projects and recordings are never mounted there. */
export const SCRIPTS_FOLDER = 'assets';

/**
 * Headers of all responses for the editor. Styles allow `'unsafe-inline'`, because Monaco and React set styles at run time; workers
 * are files. Neither page may connect to other addresses.
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
  // Includes the path, because files of projects and recordings on this origin must never run as scripts.
  const ownScripts = `${origins.preview}/${SCRIPTS_FOLDER}/`;
  return headers([
    "default-src 'none'",
    // Decoders of models use WebAssembly. `eval` stays forbidden.
    `script-src ${ownScripts} 'wasm-unsafe-eval'`,
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' blob: data:",
    // Videos play from memory.
    'media-src blob:',
    "connect-src 'self'",
    `worker-src ${ownScripts} blob:`,
    "base-uri 'none'",
    "form-action 'none'",
    `frame-ancestors ${origins.editor}`,
  ]);
}

/** Headers for files of projects and recordings. Opened as a page, they can run nothing. */
export function dataHeaders(): Record<string, string> {
  return { ...headers(["default-src 'none'", 'sandbox', "frame-ancestors 'none'"]), 'cache-control': 'no-store' };
}

function headers(policy: readonly string[]): Record<string, string> {
  return {
    'content-security-policy': policy.join('; '),
    'cross-origin-resource-policy': 'same-origin',
    'cross-origin-opener-policy': 'same-origin',
    // Browsers then run editor and preview in processes of their own, although they are the same site: neither blocks the other.
    'origin-agent-cluster': '?1',
    'referrer-policy': 'no-referrer',
    'x-content-type-options': 'nosniff',
  };
}
