/** The words of a list that a designer typed, parted by commas: `Day, Dusk, Night`. */
export function choiceOptions(text: string): string[] {
  return text
    .split(',')
    .map((word) => word.trim())
    .filter((word) => word !== '');
}
