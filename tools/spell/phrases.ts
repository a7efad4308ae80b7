import { lineOf } from '../layers/syntax.ts';

/** Phrases that readers have to read twice, each with a replacement. Common words do not belong here. */
export const BANNED_PHRASES: readonly (readonly [phrase: string, instead: string])[] = [
  ['is to be had', 'is available'],
  ['are to be had', 'are available'],
  ['not to be had', 'not available'],
  ['will not do', 'is invalid'],
  ['be mended', 'be fixed'],
  ['is called so', 'has this name'],
  ['nothing is wired', 'is not connected'],
  ['nothing wired', 'not connected'],
  ['takes away what', 'removes'],
  ['hangs in the air', 'is not connected'],
  ['drawn anew', 'drawn again'],
  ['made anew', 'created again'],
  ['for its like', 'for similar cases'],
  ['of its like', 'of this kind'],
  ['goes round', 'repeats'],
  ['go round', 'repeat'],
  ['lays hold', 'selects'],
  ['take hold of', 'select'],
  ['takes hold of', 'selects'],
  ['put up with', 'accept'],
  ['asks for nothing', 'requests nothing'],
  ['is told of', 'is notified of'],
  ['are told of', 'are notified of'],
  ['by itself alone', 'alone'],
  ['nobody knew', 'was unknown'],
  ['frames of before', 'previous frames'],
  ['the frame before', 'the previous frame'],
  ['as it were', 'remove it'],
  ['frames a second', 'frames per second'],
  ['shown outside', 'exposed'],
  ['without ado', 'directly'],
  ['comes to nothing', 'has no effect'],
  ['whoever', 'the caller, the node that …'],
  ['again and again', 'repeatedly'],
  ['to and fro', 'ping-pong'],
  ['the like', 'similar'],
  ['wherever it is', 'at any place'],
  ['in vain', 'without effect'],
];

const PATTERN = new RegExp(`\\b(${BANNED_PHRASES.map(([phrase]) => phrase.replaceAll(' ', '\\s+(?:[*/]+\\s+)?')).join('|')})\\b`, 'gi');

/** Finds phrases also across line breaks in comments. */
export function findPhrases(path: string, text: string): string[] {
  return [...text.matchAll(PATTERN)].map(({ 0: found, index }) => {
    const phrase = found.replace(/[\s*/]+/g, ' ').toLowerCase();
    const instead = BANNED_PHRASES.find(([banned]) => banned === phrase)?.[1] ?? '';
    return `${path}:${lineOf(text, index)}: “${phrase}”: write ${instead}.`;
  });
}
