/** Stands for the functions that a page does without. */
export function absent(): never {
  throw new Error('The page was made without this.');
}
