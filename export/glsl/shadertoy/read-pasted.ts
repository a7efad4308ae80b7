import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { BUFFER_LETTERS, type BufferLetter, CHANNEL_COUNT, type Channel, type Shadertoy, type Tab, tabName } from './shadertoy.ts';

/**
 * A line that says which tab follows, as people write it when they paste several: `// Buffer A`, `//==== Common ====`,
 * `// [Image tab]`, `Buf B:`. Alone on its line, so that ordinary comments are none.
 */
const HEADING =
  /^[\s/*#=\-_~<>[\](){}|.]*(?:tab\s*:?\s*)?(common|image|buf(?:fer)?[\s_-]*([A-D]))(?:\s+(?:tab|code|pass))?[\s/*#:=\-_~<>[\](){}|.]*$/i;

/** `// iChannel0: Buffer A`, `#iChannel0 "file://buffer_a.glsl"`, `// iChannel1 = self`. */
const CHANNEL_NOTE = /^[\s/*#-]*iChannel([0-3])\s*[:=\->]*\s*(?:is\s+)?["'<(]*(?:file:\/\/)?[./]*(self|buf(?:fer)?[\s_-]*([A-D]))\b/i;

/** An image that an extension of an editor reads from a disk: no GLSL. */
const CHANNEL_DIRECTIVE = /^\s*#iChannel[0-3]\b/;

interface Section {
  /** Null before the first heading. */
  readonly tab: 'common' | 'image' | BufferLetter | null;
  readonly lines: string[];
}

/** Takes pasted text apart: one tab, or several with a line before each that says which it is. */
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

/** Comments of several lines: a heading alone in one is brought onto one line; others are no place for headings. */
const BLOCK = /\/\*[\s\S]*?\*\//g;

/** Text is never lost: a heading that is a comment stays as the first line of what it heads. */
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

/** Whether a comment that takes several lines is still open after the line. */
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

/** As notes in the text say; else the first channel is the first buffer, and so on, which is what most works do. */
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

/** Directives that only say what a channel is are kept as comments. */
export function withoutChannelDirectives(code: string): string {
  return code
    .split('\n')
    .map((line) => (CHANNEL_DIRECTIVE.test(line) ? `//${line}` : line))
    .join('\n');
}
