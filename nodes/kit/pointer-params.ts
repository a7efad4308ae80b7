/** Params of nodes that read pointers: the same choice has the same words in each of them. */

/** The param that chooses which pointers a node reads; the node adds its options. */
export const POINTERS_BY = {
  type: 'choice',
  stage: 'structure',
  label: 'By',
  doc: 'Which pointers the node reacts to.',
  default: 'any',
} as const;

/** The first choices of the param; a node adds further ones that distinguish controllers and hands. */
export const ANY_OR_SCREEN = [
  { value: 'any', label: 'Anything' },
  { value: 'screen', label: 'Screen and mouse' },
] as const;
