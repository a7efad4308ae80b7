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

/**
 * The index of a choice that a number selects: rounded, and clamped to the choices.
 *
 * @param number Any number, such as the value of a wire.
 * @param count How many choices there are.
 * @returns An integer in [0, count - 1].
 *
 * @example
 * choiceIndex(1.6, 3); // 2
 */
export function choiceIndex(number: number, count: number): number {
  return Math.max(0, Math.min(Math.round(number), count - 1));
}
