import type { SessionFile } from './session-format.ts';

/** Decimals of all numbers in the file. Lengths are thus rounded to a micrometer, far below the precision of any camera. */
const DECIMALS = 6;

/** Text of `session.json`: one frame per line, without floating-point noise. */
export function printSession(session: SessionFile): string {
  const { frames, ...head } = session;
  const lines = Object.entries(head).map(([name, value]) => `  ${JSON.stringify(name)}: ${print(value)}`);
  const printed = frames.map((frame) => `    ${print(frame)}`).join(',\n');
  return `{\n${lines.join(',\n')},\n  "frames": [\n${printed}\n  ]\n}\n`;
}

function print(value: unknown): string {
  return JSON.stringify(value, (_, part: unknown) => (typeof part === 'number' ? Number(part.toFixed(DECIMALS)) + 0 : part));
}
