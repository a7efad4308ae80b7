import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { BUFFER_LETTERS, type BufferLetter, CHANNEL_COUNT, type Channel, type Shadertoy, type Tab, tabName } from './shadertoy.ts';

/**
 * A heading that names the following tab, as in pasted texts: `// Buffer A`, `//==== Common ====`, `// [Image tab]`, `Buf B:`. It must be
 * alone on its line, so that ordinary comments do not match.
 */
const HEADING =
  /^[\s/*#=\-_~<>[\](){}|.]*(?:tab\s*:?\s*)?(common|image|buf(?:fer)?[\s_-]*([A-D]))(?:\s+(?:tab|code|pass))?[\s/*#:=\-_~<>[\](){}|.]*$/i;

/** A note that names the content of a channel: `// iChannel0: Buffer A`, `#iChannel0 "file://buffer_a.glsl"`, `// iChannel1 = self`. */
const CHANNEL_NOTE = /^[\s/*#-]*iChannel([0-3])\s*[:=\->]*\s*(?:is\s+)?["'<(]*(?:file:\/\/)?[./]*(self|buf(?:fer)?[\s_-]*([A-D]))\b/i;

/** A directive of editor extensions that reads an image from a disk; not GLSL. */
const CHANNEL_DIRECTIVE = /^\s*#iChannel[0-3]\b/;

interface Section {
  /** The tab that the heading names; null for text before the first heading. */
  readonly tab: 'common' | 'image' | BufferLetter | null;
  readonly lines: string[];
}

/** Splits pasted text into tabs: one tab, or several with a heading before each. */
export function readPasted(source: string, file: string): Result<Shadertoy> {
  const sections = cut(source);
  const common: string[] = [];
  const codes = new Map<BufferLetter | null, string[]>();
  for (const { tab, lines } of sections) {
    const code = lines.join('\n');
    const place = tab ?? (hasMain(code) ? 'image' : 'common');
    if (place === 'common') common.push(code);
    else codes.set(place === 'image' ? null : place, [...(codes.get(place === 'image' ? null : place) ?? []), code]);
  }
  const letters = BUFFER_LETTERS.filter((letter) => codes.has(letter));
  const diagnostics: Diagnostic[] = [];
  const tabs = [...letters, null].flatMap((buffer): Tab[] => {
    const code = codes.get(buffer)?.join('\n');
    return code === undefined ? [] : [{ buffer, code, channels: channelsOf(code, { buffer, letters, file, diagnostics }) }];
  });
  const shader: Shadertoy = { title: '', description: '', tags: [], credit: '', tabs, common: common.join('\n').trim() };
  return { output: shader, diagnostics };
}

export function hasMain(code: string): boolean {
  return /\bvoid\s+mainImage\s*\(/.test(code);
}

/** Matches block comments. One of several lines that contains only a heading is joined to one line; in others, headings are ignored. */
const BLOCK = /\/\*[\s\S]*?\*\//g;

/** Cuts a text into sections at its headings. All text stays: a heading that is a comment stays as the first line of its section. */
function cut(source: string): Section[] {
  const sections: Section[] = [{ tab: null, lines: [] }];
  const plain = source.replace(/\r\n|\r/g, '\n').replace(BLOCK, (block) => {
    const words = block.replace(/\s+/g, ' ');
    return block.includes('\n') && HEADING.test(words) ? words : block;
  });
  let blockOpen = false;
  for (const line of plain.split('\n')) {
    const heading = blockOpen ? null : HEADING.exec(line);
    blockOpen = isBlockOpen(line, blockOpen);
    if (heading) sections.push({ tab: tabOf(heading), lines: /^\s*\/[/*]/.test(line) ? [line] : [] });
    else sections.at(-1)?.lines.push(line);
  }
  return sections.filter(({ lines }) => lines.some((line) => line.trim() !== ''));
}

/** Whether a multi-line comment is still open after the line. */
function isBlockOpen(line: string, before: boolean): boolean {
  const rest = (before ? `/*${line}` : line).replace(BLOCK, '').replace(/\/\/.*$/, (comment) => (before ? comment : ''));
  return rest.includes('/*');
}

function tabOf([, word = '', letter]: RegExpExecArray): 'common' | 'image' | BufferLetter {
  const buffer = BUFFER_LETTERS.find((one) => one === letter?.toUpperCase());
  return buffer ?? (word.toLowerCase() === 'common' ? 'common' : 'image');
}

interface ChannelContext {
  readonly buffer: BufferLetter | null;
  readonly letters: readonly BufferLetter[];
  readonly file: string;
  readonly diagnostics: Diagnostic[];
}

/** The channels of a tab by the notes in its text; without notes, the first channel is the first buffer and so on, as in most works. */
function channelsOf(code: string, { buffer, letters, file, diagnostics }: ChannelContext): Channel[] {
  const noted = new Map<number, BufferLetter>();
  for (const line of code.split('\n')) {
    const note = CHANNEL_NOTE.exec(line);
    const letter = note?.[2]?.toLowerCase() === 'self' ? buffer : BUFFER_LETTERS.find((one) => one === note?.[3]?.toUpperCase());
    if (note && letter) noted.set(Number(note[1]), letter);
  }
  return Array.from({ length: CHANNEL_COUNT }, (_, index): Channel => {
    const known = noted.get(index);
    if (known !== undefined) return { kind: 'buffer', buffer: known };
    const guess = letters[index];
    const used = new RegExp(`\\biChannel${index}\\b`).test(code);
    if (guess === undefined || noted.size > 0) return { kind: 'picture', key: `iChannel${index}`, repeat: true };
    if (used) {
      diagnostics.push({
        code: 'SCR045',
        severity: 'warning',
        file,
        message: `iChannel${index} of ${tabName({ buffer })} is not specified. Buffer ${guess} is used.`,
        fix: `Add a line such as "// iChannel${index}: Buffer A" below the heading of the tab to change it.`,
      });
    }
    return { kind: 'buffer', buffer: guess };
  });
}

/** Turns directives that describe a channel into comments. */
export function withoutChannelDirectives(code: string): string {
  return code
    .split('\n')
    .map((line) => (CHANNEL_DIRECTIVE.test(line) ? `//${line}` : line))
    .join('\n');
}
