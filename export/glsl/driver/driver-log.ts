export interface LogLine {
  readonly severity: 'error' | 'warning';
  /** Printed line from 1, or null if the driver gives none. */
  readonly line: number | null;
  readonly quoted: string | null;
  readonly message: string;
}

/** Format of ANGLE, which Chromium uses: `ERROR: 0:12: 'foo' : undeclared identifier`. */
const ANGLE = /^(ERROR|WARNING):\s*(?:\d+:(\d+):\s*)?(?:'([^']*)'\s*:\s*)?(.*)$/;

/** Format of Mesa and similar drivers: `0:12(5): error: …`. */
const MESA = /^\d+:(\d+)\(\d+\):\s*(error|warning):\s*(.*)$/;

/** Messages that are left out, because drivers follow them with a better one about the same token. */
const FORERUNNERS = /^(?:dimension mismatch|array \/ non-array mismatch|Invalid operation for structs)/i;

/** Parses a log. One that is not empty gives at least one line. */
export function readLog(log: string): readonly LogLine[] {
  const text = log.replaceAll('\0', '').trim();
  const lines = text
    .split('\n')
    .map((line) => readLine(line.trim()))
    .filter((line) => line !== null);
  const [first] = text.split('\n');
  if (lines.length === 0 && first) return [{ severity: 'error', line: null, quoted: null, message: first }];
  return lines.filter((line, i) => {
    const next = lines[i + 1];
    const isSame = next !== undefined && next.line === line.line && (next.quoted === line.quoted || next.quoted === 'assign');
    return !(FORERUNNERS.test(line.message) && isSame);
  });
}

function readLine(text: string): LogLine | null {
  const angle = ANGLE.exec(text);
  if (angle !== null) {
    const [, severity, line, quoted, message = ''] = angle;
    return {
      severity: severity === 'WARNING' ? 'warning' : 'error',
      line: line === undefined ? null : Number(line),
      quoted: quoted ?? null,
      message,
    };
  }
  const mesa = MESA.exec(text);
  if (mesa === null) return null;
  const [, line, severity, message = ''] = mesa;
  return {
    severity: severity === 'warning' ? 'warning' : 'error',
    line: Number(line),
    quoted: /[`'"]([^`'"]+)[`'"]/.exec(message)?.[1] ?? null,
    message,
  };
}
