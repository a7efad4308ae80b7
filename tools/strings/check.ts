import type { UserString } from './read-strings.ts';

const MOST_COMMAND_WORDS = 4;
const MOST_SENTENCE_WORDS = 20;

export function checkStrings(strings: readonly UserString[]): string[] {
  const problems: string[] = [];
  for (const string of strings) {
    for (const fault of faultsOf(string)) problems.push(`${string.file}: “${string.text}”: ${fault}`);
  }
  return [...problems, ...nearEqual(strings)];
}

function faultsOf({ kind, text }: UserString): string[] {
  if (kind === 'command') return commandFaults(text);
  if (kind === 'problem') return problemFaults(text);
  if (kind === 'remedy') return remedyFaults(text);
  return [];
}

function commandFaults(text: string): string[] {
  const faults: string[] = [];
  const words = text.split(' ');
  if (words.length > MOST_COMMAND_WORDS) faults.push(`a command has at most ${MOST_COMMAND_WORDS} words`);
  if (text.endsWith('.')) faults.push('a command has no full stop');
  if (words.slice(1).some((word) => /^[A-Z][a-z]/.test(word) && !NAMES.has(word.replace(/…$/, '')))) {
    faults.push('a command is written in sentence case');
  }
  return faults;
}

/** Names of products keep their capital in the middle of a command. */
const NAMES = new Set(['Shadertoy', 'Scrim']);

function problemFaults(text: string): string[] {
  const faults: string[] = [];
  // A part of a sentence that is completed elsewhere begins or ends with a hole, and is checked where it is whole.
  if (/[\w”)]$/.test(text) && / /.test(text)) faults.push('a problem ends with a full stop');
  for (const sentence of text.split(/(?<=[.!?])\s+/)) {
    if (sentence.split(/\s+/).length > MOST_SENTENCE_WORDS) faults.push(`a sentence of a problem has at most ${MOST_SENTENCE_WORDS} words`);
  }
  return faults;
}

function remedyFaults(text: string): string[] {
  return /^(It|The|There|This|That|These|A|An|You|Where|When|If|[A-Z][a-z]+ing)\b/.test(text) ? ['a remedy begins with what to do'] : [];
}

/**
 * Reports strings that differ only in case, spaces or punctuation, where one would be enough. “…” and “?” are real differences: “Open…”
 * opens the dialog “Open”.
 */
function nearEqual(strings: readonly UserString[]): string[] {
  const byWords = new Map<string, Map<string, string>>();
  for (const { text, file, kind } of strings) {
    if (kind === 'title' || kind === 'label') continue;
    const words = text
      .toLowerCase()
      .replace(/[^\p{L}\p{N}{}…?]+/gu, ' ')
      .trim();
    if (words.split(' ').filter((word) => word !== '{}').length < 4) continue;
    const texts = byWords.get(words) ?? new Map<string, string>();
    texts.set(text, file);
    byWords.set(words, texts);
  }
  return [...byWords.values()]
    .filter((texts) => texts.size > 1)
    .map((texts) => `Nearly equal: ${[...texts].map(([text, file]) => `“${text}” (${file})`).join(', ')}`);
}
