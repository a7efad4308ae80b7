/** British stems and the American ones that Scrim writes. Searches accept both. */
const AMERICAN: readonly (readonly [british: string, american: string])[] = [
  ['colour', 'color'],
  ['grey', 'gray'],
  ['centre', 'center'],
  ['metre', 'meter'],
  ['licence', 'license'],
  ['neighbour', 'neighbor'],
  ['behaviour', 'behavior'],
  ['equalis', 'equaliz'],
  ['normalis', 'normaliz'],
  ['optimis', 'optimiz'],
];

/** Text as searches compare it: in lower case and American spelling. */
export function searchable(text: string): string {
  return AMERICAN.reduce((result, [british, american]) => result.replaceAll(british, american), text.toLowerCase());
}
