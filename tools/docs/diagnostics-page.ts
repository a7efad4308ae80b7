import { DIAGNOSTICS, type DiagnosticCode } from '../../nodes/kit/diagnostics.ts';
import { ADVICE } from './advice.ts';

const GROUPS = [
  ['Documents', 0],
  ['Graphs', 10],
  ['Assets', 30],
  ['Shaders', 40],
  ['Sessions', 50],
  ['Files and export', 60],
  ['Command line and host', 70],
] as const;

/** Text of `docs/diagnostics.md`: every code, what it means and what to do. */
export function diagnosticsPage(): string {
  const codes = Object.keys(DIAGNOSTICS).sort() as DiagnosticCode[];
  const sections = GROUPS.map(([title, from], index) => {
    const to = GROUPS[index + 1]?.[1] ?? 1000;
    const own = codes.filter((code) => numberOf(code) >= from && numberOf(code) < to);
    return `## ${title}\n\n${own.map(entry).join('\n')}`;
  });
  return `# Diagnostics

<!-- Made by \`npm run docs\`; change nodes/kit/diagnostics.ts and tools/docs/advice.ts instead. -->

Scrim says what is wrong as a diagnostic: a code, the place (node and port, or file, line and column), and a message. Errors keep a project from being exported; warnings and notes do not. Opening, checking or exporting a project with errors never changes its files.

${sections.join('\n')}`;
}

function entry(code: DiagnosticCode): string {
  return `### ${code}\n\n**${DIAGNOSTICS[code]}.** ${ADVICE[code]}\n`;
}

function numberOf(code: DiagnosticCode): number {
  return Number(code.slice(3));
}
