/** Params of nodes that read pointers: the same choice has the same words in each of them. */

/** Which pointers count, without the choices. */
export const POINTERS_BY = {
  type: 'choice',
  stage: 'structure',
  label: 'By',
  doc: 'Which pointers the node reacts to.',
  default: 'any',
} as const;

/** The choices that come first; a node adds those that tell controllers and hands apart. */
export const ANY_OR_SCREEN = [
  { value: 'any', label: 'Anything' },
  { value: 'screen', label: 'Screen and mouse' },
] as const;
