import type { Ask } from './needs-text.ts';

/** What `index.html` says; all paths are relative to it, so that the page works below any address. */
export interface PageHtml {
  readonly title: string;
  readonly description: string;
  /** BCP 47. */
  readonly language: string;
  readonly script: string;
  readonly style: string;
  readonly config: PageConfig;
}

/** What the script is told by the page, as JSON in it: data, which no policy has to allow. */
export interface PageConfig {
  readonly title: string;
  readonly description: string;
  /** What entering AR will ask for. */
  readonly asks: readonly Ask[];
  readonly program: string;
  /** Bytes to load before the first picture, for the progress bar: path → size. */
  readonly bytes: Readonly<Record<string, number>>;
}

export const CONFIG_ID = 'scrim-page';

/** Only what lies beside the page; the empty icon is all that is data. */
const POLICY = [
  "default-src 'none'",
  "script-src 'self'",
  "style-src 'self'",
  "img-src 'self' data:",
  "connect-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** The policy comes first: it rules what follows it. */
export function pageHtml({ title, description, language, script, style, config }: PageHtml): string {
  const text = escapeHtml(title);
  return `<!doctype html>
<html lang="${escapeHtml(language)}">
<head>
<meta charset="utf-8">
<meta http-equiv="content-security-policy" content="${POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1, viewport-fit=cover">
<title>${text}</title>
<meta name="description" content="${escapeHtml(description === '' ? title : description)}">
<meta name="theme-color" content="#14161a">
<meta name="color-scheme" content="dark">
<meta name="generator" content="Scrim">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${escapeHtml(style)}">
<link rel="preload" href="${escapeHtml(config.program)}" as="fetch" crossorigin>
<script src="${escapeHtml(script)}" defer></script>
<script type="application/json" id="${CONFIG_ID}">${escapeJson(config)}</script>
</head>
<body>
<noscript>${text} needs JavaScript: it draws in real time.</noscript>
</body>
</html>
`;
}

export function escapeHtml(text: string): string {
  return text.replace(/[&<>"']/g, (character) => `&#${character.charCodeAt(0)};`);
}

/** No tag can end the data block early. */
function escapeJson(value: unknown): string {
  return JSON.stringify(value).replace(/</g, '\\u003c');
}
