import { createHash } from 'node:crypto';
import { type InlineText, type PageConfig, type PageHtml, type Poster, pageHtml } from '../page/page-html.ts';
import type { PagePowers } from '../page/page-policy.ts';
import { hashedName } from './hashed-name.ts';
import type { PosterImage } from './poster.ts';
import type { FileKind } from './report.ts';
import { OFFLINE_FILE, offlineScript } from './service-worker.ts';

/** A file of the page with its path there. */
export interface PageFile {
  readonly path: string;
  readonly kind: FileKind;
  readonly bytes: Uint8Array;
}

export interface LayoutInput {
  readonly title: string;
  readonly description: string;
  readonly language: string;
  /** Address of the published page, ending in `/`, or null. */
  readonly address: string | null;
  /** Whether the page has a service worker. */
  readonly offline: boolean;
  readonly script: Uint8Array;
  /** Script with the sessions that a visitor enters; null if `script` contains them. */
  readonly sessions: Uint8Array | null;
  readonly style: Uint8Array;
  readonly poster: PosterImage;
  /** Files that the script loads, including the program, in any order. */
  readonly content: readonly PageFile[];
  readonly config: Omit<PageConfig, 'bytes' | 'sessions' | 'offline' | 'title' | 'description'>;
  readonly powers: PagePowers;
}

/**
 * Files of a page. Names contain a hash of the content, except for the page and its service worker, so that hosts can cache them without
 * limit.
 */
export function layOutFiles(input: LayoutInput): PageFile[] {
  const { script, sessions, style, poster, content, address, offline } = input;
  const page: PageFile = { path: hashedName('page.js', script), kind: 'script', bytes: script };
  const entered = sessions && ({ path: hashedName('sessions.js', sessions), kind: 'script', bytes: sessions } satisfies PageFile);
  const sheet: PageFile = { path: hashedName('page.css', style), kind: 'style', bytes: style };
  const image: PageFile = { path: hashedName(`poster.${poster.type}`, poster.bytes), kind: 'poster', bytes: poster.bytes };
  const html = pageHtml({
    ...head(input),
    address,
    parts: { kind: 'files', script: page.path, style: sheet.path, preloaded: preloaded(content) },
    poster: posterOf(image.path, poster),
    config: configOf(input, entered?.path ?? null, offline ? OFFLINE_FILE : null),
  });
  const index: PageFile = { path: 'index.html', kind: 'page', bytes: toBytes(html) };
  // A neutral poster is used by link previews only.
  const scripts = entered ? [page, entered] : [page];
  const shown = [...scripts, sheet, ...(poster.drawn ? [image] : []), ...content];
  const worker: PageFile = { path: OFFLINE_FILE, kind: 'offline', bytes: toBytes(offlineScript(index, shown)) };
  return [index, ...scripts, sheet, image, ...(offline ? [worker] : []), ...content];
}

/** The page as one file, which opens without a server. It loads nothing, so it needs no service worker. */
export function layOutSingleFile(input: LayoutInput): PageFile[] {
  const { script, style, poster, content } = input;
  const html = pageHtml({
    ...head(input),
    address: null,
    parts: {
      kind: 'single',
      script: inline(scriptText(new TextDecoder().decode(script))),
      style: inline(new TextDecoder().decode(style).trim()),
      files: Object.fromEntries(content.map(({ path, bytes }) => [path, base64(bytes)])),
    },
    poster: posterOf(`data:image/${poster.type === 'jpg' ? 'jpeg' : poster.type};base64,${base64(poster.bytes)}`, poster),
    config: configOf(input, null, null),
  });
  return [{ path: 'index.html', kind: 'page', bytes: toBytes(html) }];
}

/** Kinds of assets that the first image shows. */
const SHOWN_FIRST: ReadonlySet<FileKind> = new Set(['model', 'image']);

/** Bytes of assets that are loaded beside the script; more would delay it. */
const MAX_PRELOADED_BYTES = 500_000;

/** The assets that are loaded beside the script, so that they do not wait until it runs. */
function preloaded(content: readonly PageFile[]): readonly string[] {
  const shown = content.filter(({ kind }) => SHOWN_FIRST.has(kind));
  return shown.reduce((sum, { bytes }) => sum + bytes.length, 0) <= MAX_PRELOADED_BYTES ? shown.map(({ path }) => path) : [];
}

function head({ title, description, language, powers }: LayoutInput): Pick<PageHtml, 'title' | 'description' | 'language' | 'powers'> {
  return { title, description, language, powers };
}

function posterOf(source: string, { widthPx, heightPx, drawn }: PosterImage): Poster {
  return { source, widthPx, heightPx, drawn };
}

function configOf({ title, description, config, content }: LayoutInput, sessions: string | null, offline: string | null): PageConfig {
  const bytes = Object.fromEntries(content.map(({ path, bytes }) => [path, bytes.length]));
  return { title, description, ...config, bytes, sessions, offline };
}

/**
 * Escapes text that would end the script element or start a comment. Minified scripts contain it only in strings and regular expressions,
 * where a backslash changes nothing.
 */
function scriptText(text: string): string {
  return text
    .replace(/<\/(script)/gi, '<\\/$1')
    .replaceAll('<!--', '<\\!--')
    .trim();
}

function inline(text: string): InlineText {
  return { text, hash: `sha256-${createHash('sha256').update(text).digest('base64')}` };
}

function base64(bytes: Uint8Array): string {
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString('base64');
}

export function toBytes(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}
