export interface Terms {
  /** The author named in comments; empty if there is none. */
  readonly credit: string;
  /** The license; empty if there is none. */
  readonly licence: string;
}

const COMMENT = /\/\/[^\r\n]*|\/\*[\s\S]*?\*\//g;

/** Words that introduce an author. */
const CREDIT =
  /©|\(c\)|\bcopyright\b|\bauthors?\b|\bcredits?\b|\b(?:created|written|made|coded|designed|ported|modified|shader|original(?:ly)?)\s+(?:by|from)\b|\bport of\b|\bfork(?:ed)?\s+(?:of|from)\b|\bbased (?:on|off)\b|\badapted from\b|\bthanks to\b|\bshadertoy\.com\/(?:view|user)\b|^by\s+\S|\bby\s+\S.*\b(?:19|20)\d\d\b/i;

/** Licenses by the words that name them. The first match counts, so longer names come before those that they contain. */
const LICENCES: readonly (readonly [RegExp, string])[] = [
  [/\bCC0\b|\bpublic domain\b/i, 'CC0 (public domain)'],
  [/\bunlicense\b/i, 'Unlicense (public domain)'],
  [/\bBY[- ]NC[- ]SA\b|Attribution[-\s]*Non-?\s?Commercial[-\s]*Share-?\s?Alike/i, 'CC BY-NC-SA'],
  [/\bBY[- ]NC[- ]ND\b|Attribution[-\s]*Non-?\s?Commercial[-\s]*No-?\s?Deriv/i, 'CC BY-NC-ND'],
  [/\bBY[- ]NC\b|Attribution[-\s]*Non-?\s?Commercial/i, 'CC BY-NC'],
  [/\bBY[- ]SA\b|Attribution[-\s]*Share-?\s?Alike/i, 'CC BY-SA'],
  [/\bBY[- ]ND\b|Attribution[-\s]*No-?\s?Deriv/i, 'CC BY-ND'],
  [/\bCC[- ]BY\b|\bcreative commons attribution\b/i, 'CC BY'],
  [/\bMIT\b|Permission is hereby granted, free of charge/i, 'MIT'],
  [/\bApache\b/i, 'Apache 2.0'],
  [/\bBSD\b|Redistribution and use in source and binary forms/i, 'BSD'],
  [/\bAGPL/i, 'AGPL'],
  [/\bLGPL/i, 'LGPL'],
  [/\bGPL|\bGNU General Public/i, 'GPL'],
  [/\bMPL\b|\bMozilla Public/i, 'MPL 2.0'],
  [/\bWTFPL\b/i, 'WTFPL'],
  [/\bzlib licen[sc]e\b/i, 'zlib'],
  [/\bISC licen[sc]e\b/i, 'ISC'],
  [/\ball rights reserved\b/i, 'All rights reserved'],
];

const VERSION = /\b([1-4]\.0)\b/;
const SPEAKS_OF_LICENCE = /\blicen[sc]ed?\b/i;

/** Maximum lines of a credit, because comments may be long. */
const MAX_CREDIT_LINES = 6;

/** Finds author and license in the comments of a source. An unknown license is quoted. */
export function findTerms(source: string): Terms {
  const lines = commentLines(source);
  const credit = [...new Set(lines.filter((line) => CREDIT.test(line)))].slice(0, MAX_CREDIT_LINES).join('; ');
  return { credit, licence: licenceOf(lines) };
}

function licenceOf(lines: readonly string[]): string {
  const text = lines.join(' ');
  const known = LICENCES.find(([pattern]) => pattern.test(text));
  if (known) {
    const [pattern, name] = known;
    const version = name.startsWith('CC BY') ? VERSION.exec(text.slice(text.search(pattern)))?.[1] : undefined;
    return version === undefined ? name : `${name} ${version}`;
  }
  const line = lines.find((one) => SPEAKS_OF_LICENCE.test(one));
  return line === undefined ? '' : `As its source says: ${line}`;
}

/** The text of all comments without decoration. */
function commentLines(source: string): string[] {
  return [...source.matchAll(COMMENT)]
    .flatMap(([comment]) => comment.replace(/^\/\*|\*\/$/g, '').split(/\r\n|\r|\n/))
    .map((line) => line.replace(/^[\s/*=~#_+-]+|[\s/*=~#_+-]+$/g, ''))
    .filter((line) => line !== '');
}
