/** The place that a number stands for: rounded, and within what there is. */
export function choiceIndex(number: number, count: number): number {
  return Math.max(0, Math.min(Math.round(number), count - 1));
}
