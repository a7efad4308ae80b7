import { type Diagnostic, formatDiagnostic } from '../../nodes/kit/diagnostics.ts';

/** Functions that color text, or return it unchanged. */
export interface Paint {
  diagnostic(diagnostic: Diagnostic): string;
}

/** ECMA-48 codes: bold red, bold yellow, bold blue. */
const COLORS = { error: '1;31', warning: '1;33', info: '1;34' } as const;

export function createPaint(colored: boolean): Paint {
  return {
    diagnostic: (diagnostic) => {
      const line = formatDiagnostic(diagnostic);
      if (!colored) return line;
      const { severity, code } = diagnostic;
      return line.replace(`${severity} ${code}`, (words) => `\x1b[${COLORS[severity]}m${words}\x1b[0m`);
    },
  };
}

/** Whether a stream is colored: a terminal that supports it, unless the environment forbids it (no-color.org). */
export function wantsColor(isTerminal: boolean, env: Readonly<Record<string, string | undefined>>): boolean {
  if (env.NO_COLOR) return false;
  if (env.FORCE_COLOR) return env.FORCE_COLOR !== '0';
  return isTerminal && env.TERM !== 'dumb';
}
