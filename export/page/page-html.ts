import type { Control, ProgramCredit, Tier } from '../program/program.ts';
import type { Ask } from './needs-text.ts';
import { type PagePowers, pagePolicy } from './page-policy.ts';

/** What `index.html` says; all paths are relative to it, so that the page works below any address. */
export interface PageHtml {
  readonly title: string;
  readonly description: string;
  /** BCP 47. */
  readonly language: string;
  readonly parts: PageParts;
  readonly poster: Poster;
  /** Where the page will be published, ending in `/`, or null where nobody knows yet. */
  readonly address: string | null;
  readonly config: PageConfig;
  readonly powers: PagePowers;
}

/** Script and style: files, or the texts themselves with what a policy knows them by. */
export type PageParts =
  | { readonly kind: 'files'; readonly script: string; readonly style: string }
  | {
      readonly kind: 'single';
      readonly script: InlineText;
      readonly style: InlineText;
      /** Everything that a page of several files would have beside it: path → base64. */
      readonly files: Readonly<Record<string, string>>;
    };

/** `hash`: `sha256-` and base64, of the text as it stands in the page. */
export interface InlineText {
  readonly text: string;
  readonly hash: string;
}

/** A picture of the page, for those who link to it, and while it loads. */
export interface Poster {
  /** A path, or a `data:` URL. */
  readonly source: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Shows what the page shows; else it is no more than a backdrop, not worth loading before the page. */
  readonly drawn: boolean;
}

/** What the script is told by the page, as JSON in it: data, which no policy has to allow. */
export interface PageConfig {
  readonly title: string;
  readonly description: string;
  /** What entering AR will ask for. */
  readonly asks: readonly Ask[];
  readonly tiers: readonly Tier[];
  /** What visitors can set, from top to bottom. */
  readonly controls: readonly Control[];
  /** Whose works the page is made of. */
  readonly credits: readonly Omit<ProgramCredit, 'nodes'>[];
  readonly program: string;
  /** Files of three's decoders that the page's models need, by the names that `export/gltf/decoders.ts` gives them. */
  readonly decoders: Readonly<Record<string, string>>;
  /** Bytes to load before the first picture, for the progress bar: path → size. */
  readonly bytes: Readonly<Record<string, number>>;
  /** The service worker, or null for a page in one file. */
  readonly offline: string | null;
}

export const CONFIG_ID = 'scrim-page';

/** Type of the data blocks that hold the files of a page in one file; `data-path` names each. No browser runs them. */
export const EMBEDDED_TYPE = 'application/x-scrim-file';

/**
 * The policy comes first: it rules what follows it. What stands in `main` is shown until the script, which may be large, takes its
 * place; it looks the same.
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

/** Those who show links want whole addresses; some make do with one that is relative. */
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
  return `<link rel="stylesheet" href="${escapeHtml(parts.style)}">
<link rel="preload" href="${escapeHtml(config.program)}" as="fetch" crossorigin>
<script src="${escapeHtml(parts.script)}" defer></script>
`;
}

/** The files first: the script looks for them when it runs. */
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

/** No tag can end the data block early. */
function escapeJson(value: unknown): string {
  return JSON.stringify(value).replace(/</g, '\\u003c');
}
