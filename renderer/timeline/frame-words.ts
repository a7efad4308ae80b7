/** A frame as people and screen readers are told of it. */
export function frameWords(frame: number, timeS: number): string {
  return `Frame ${frame}, ${timeS.toFixed(2)} s`;
}
