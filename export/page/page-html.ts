import type { Tier } from '../program/needs.ts';
import type { Control } from '../program/program.ts';
import type { ProgramCredit } from '../program/program-credit.ts';
import type { Ask } from './needs-text.ts';
import { type PagePowers, pagePolicy } from './page-policy.ts';

/** Content of `index.html`. All paths are relative, so the page works at any address. */
export interface PageHtml {
  readonly title: string;
  readonly description: string;
  /** Language of the page, as a BCP 47 tag. */
  readonly language: string;
  readonly parts: PageParts;
  readonly poster: Poster;
  /** Address of the published page, ending in `/`; null if unknown. */
  readonly address: string | null;
  readonly config: PageConfig;
  readonly powers: PagePowers;
}

/** Script and style of the page, as files or inline with their hashes for the content security policy. */
export type PageParts =
  | {
      readonly kind: 'files';
      readonly script: string;
      readonly style: string;
      /** Files that the script loads for the first image, apart from the program. */
      readonly preloaded: readonly string[];
    }
  | {
      readonly kind: 'single';
      readonly script: InlineText;
      readonly style: InlineText;
      /** The files of the page: path → base64. */
      readonly files: Readonly<Record<string, string>>;
    };

/** An inline script or style. `hash` is `sha256-` and the base64 hash of `text`. */
export interface InlineText {
  readonly text: string;
  readonly hash: string;
}

/** An image of the page for link previews, also shown while the page loads. */
export interface Poster {
  /** A path or a `data:` URL. */
  readonly source: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Whether the image shows the content of the page. Otherwise it is a plain background, which is not preloaded. */
  readonly drawn: boolean;
}

/**
 * Configuration of the page's script, as JSON in a data block of the page. Data blocks need no permission of the content security policy.
 */
export interface PageConfig {
  readonly title: string;
  readonly description: string;
  /** Features that the AR session requests. */
  readonly asks: readonly Ask[];
  readonly tiers: readonly Tier[];
  /** Whether the page does no more than change the image of the camera. */
  readonly isFilter: boolean;
  /** Whether the image depends on the view, so that visitors can look around. */
  readonly looksAround: boolean;
  /** Controls from top to bottom. */
  readonly controls: readonly Control[];
  /** Authors of the page's effects and assets. */
  readonly credits: readonly Omit<ProgramCredit, 'nodes'>[];
  readonly program: string;
  /** Decoder files that the page's models need, by their names in `export/gltf/decoders.ts`. */
  readonly decoders: Readonly<Record<string, string>>;
  /** Sizes of the files to load before the first frame, for the progress bar: path → bytes. */
  readonly bytes: Readonly<Record<string, number>>;
  /** Path of the script with the sessions that a visitor enters; null if the page's script contains them, or there are none. */
  readonly sessions: string | null;
  /** Path of the service worker; null for a single-file page. */
  readonly offline: string | null;
}

export const CONFIG_ID = 'scrim-page';

/**
 * MIME type of the data blocks with the files of a single-file page; browsers do not run this type. The attribute `data-path` of a block is
 * the path of its file.
 */
export const EMBEDDED_TYPE = 'application/x-scrim-file';

/**
 * Renders `index.html`. The content security policy comes first, because it applies only to what follows it. The content of `main` looks
 * like the page and is shown until the script replaces it.
 */
export function pageHtml({ title, description, language, parts, poster, address, config, powers }: PageHtml): string {
  const text = escapeHtml(title);
  const about = escapeHtml(description === '' ? title : description);
  const origin =
    parts.kind === 'files'
      ? ({ kind: 'files' } as const)
      : ({ kind: 'single', scriptHash: parts.script.hash, styleHash: parts.style.hash } as const);
  return `<!doctype html>
<html lang="${escapeHtml(language)}">
<head>
<meta charset="utf-8">
<meta http-equiv="content-security-policy" content="${pagePolicy(origin, powers)}">
<meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover">
<title>${text}</title>
<meta name="description" content="${about}">
<meta name="theme-color" content="#14161a">
<meta name="color-scheme" content="dark">
<meta name="generator" content="Scrim">
<meta property="og:type" content="website">
<meta property="og:title" content="${text}">
<meta property="og:description" content="${about}">
${poster.source.startsWith('data:') ? '' : imageTags(poster, text, address)}<link rel="icon" href="data:,">
${headParts(parts, config)}<script type="application/json" id="${CONFIG_ID}">${escapeJson(config)}</script>
</head>
<body>
<main>
${poster.drawn ? `<img class="poster" src="${escapeHtml(poster.source)}" alt="${text}" width="${poster.widthPx}" height="${poster.heightPx}">\n` : ''}<section class="panel">
<header><h1>${text}</h1></header>
${description === '' ? '' : `<p class="description">${about}</p>\n`}<noscript><p>This page needs JavaScript: it draws in real time. Switch it on, then reload the page.</p></noscript>
</section>
</main>
${bodyParts(parts)}</body>
</html>
`;
}

/** The `meta` elements with the image for link previews. Most previews require absolute addresses; some accept relative ones. */
function imageTags({ source, widthPx, heightPx }: Poster, title: string, address: string | null): string {
  const image = escapeHtml(address === null ? source : new URL(source, address).href);
  return `${address === null ? '' : `<meta property="og:url" content="${escapeHtml(address)}">\n`}<meta property="og:image" content="${image}">
<meta property="og:image:width" content="${widthPx}">
<meta property="og:image:height" content="${heightPx}">
<meta property="og:image:alt" content="${title}">
<meta name="twitter:card" content="summary_large_image">
`;
}

function headParts(parts: PageParts, config: PageConfig): string {
  if (parts.kind === 'single') return `<style>${parts.style.text}</style>\n`;
  // Addressed as `createFetchAssetSource` does, else browsers load the file again.
  const address = (path: string): string => path.split('/').map(encodeURIComponent).join('/');
  const preload = (path: string): string => `<link rel="preload" href="${escapeHtml(address(path))}" as="fetch" crossorigin>\n`;
  return `<link rel="stylesheet" href="${escapeHtml(parts.style)}">
${[config.program, ...parts.preloaded].map(preload).join('')}<script src="${escapeHtml(parts.script)}" defer></script>
`;
}

/**
 * The end of the body of a single-file page: embedded files, then the script, because the script reads the files when it runs. Empty for
 * other pages.
 */
function bodyParts(parts: PageParts): string {
  if (parts.kind === 'files') return '';
  const files = Object.entries(parts.files).map(
    ([path, base64]) => `<script type="${EMBEDDED_TYPE}" data-path="${escapeHtml(path)}">${base64}</script>\n`,
  );
  return `${files.join('')}<script>${parts.script.text}</script>\n`;
}

export function escapeHtml(text: string): string {
  return text.replace(/[&<>"']/g, (character) => `&#${character.charCodeAt(0)};`);
}

/** Writes JSON for a data block. `<` is escaped, so that no tag in it ends the block. */
function escapeJson(value: unknown): string {
  return JSON.stringify(value).replace(/</g, '\\u003c');
}
