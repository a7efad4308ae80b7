/** The words in a text with commas between them. */
export function wordsIn(text: string): readonly string[] {
  return text
    .split(',')
    .map((word) => word.trim())
    .filter((word) => word !== '');
}

/** A text with words, which is kept as it is typed as long as these are its words. */
export function textOfWords(words: readonly string[], typed: string): string {
  const whole = words.join(', ');
  return wordsIn(typed).join(', ') === whole ? typed : whole;
}
