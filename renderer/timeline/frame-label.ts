/** Label of a frame for tooltips and screen readers. */
export function frameLabel(frame: number, timeS: number): string {
  return `Frame ${frame}, ${timeS.toFixed(2)} s`;
}
