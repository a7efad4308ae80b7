/**
 * Splits a comma-separated list of options.
 *
 * @param text The list as a designer types it.
 * @returns The options, trimmed.
 *
 * @example
 * choiceOptions('Day, Dusk, Night'); // ['Day', 'Dusk', 'Night']
 */
export function choiceOptions(text: string): string[] {
  return text
    .split(',')
    .map((word) => word.trim())
    .filter((word) => word !== '');
}
