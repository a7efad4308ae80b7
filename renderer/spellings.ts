/** British word stems and their American spelling, which Scrim uses. Searches accept both. */
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

/** Normalizes text for searches: lower case and American spelling. */
export function searchable(text: string): string {
  return AMERICAN.reduce((result, [british, american]) => result.replaceAll(british, american), text.toLowerCase());
}
