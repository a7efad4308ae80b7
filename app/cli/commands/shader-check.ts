import { formatDiagnostic } from '../../../nodes/kit/diagnostics.ts';
import { findChromium } from '../../services/chromium.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import { type Command, EXIT, failed } from '../command.ts';
import { type CheckedFile, checkShaders } from '../shader/check-shaders.ts';
import { findShaders } from '../shader/find-shaders.ts';

export const shaderCheckCommand: Command = {
  name: 'shader check',
  usage: 'FILE|DIR…',
  summary: 'Check shader files with a graphics driver',
  doc: 'Reads ISF files (filters, composites, generators) and techniques (.glsl), compiles them with a real driver in a headless browser and runs their loops. Prints problems of the header, the syntax or the types, and endless loops, with file, line and column. Checks a vertex shader (.vs) with the ISF file beside it. Only errors give status 1.',
  project: 'required',
  operand: { word: 'FILE|DIR', doc: 'a shader, or a folder with shaders at any depth', many: true },
  options: {},
  examples: [
    {
      line: 'scrim shader check my-project/shaders',
      says: 'Prints each problem on its own line, as file:line:column: error SCR042: message.',
    },
    { line: 'scrim shader check glow.fs edge.fs --json', says: 'For other programs: { files: [{ path, ok, diagnostics }] }.' },
  ],
  run: async ({ operands }, { installation, say, interrupted }) => {
    const paths = await findShaders(operands);
    const chromium = await findChromium();
    if (chromium === null) return failed([NO_BROWSER]);
    const files = await checkShaders(paths, { root: installation.root, chromium, say, interrupted });
    const lines = files.flatMap(({ diagnostics }) => diagnostics.map(formatDiagnostic));
    return {
      status: files.every(({ ok }) => ok) ? EXIT.done : EXIT.problems,
      json: { files },
      text: [...lines, summary(files)].join('\n'),
      diagnostics: [],
    };
  },
};

function summary(files: readonly CheckedFile[]): string {
  const broken = files.filter(({ ok }) => !ok).length;
  const all = files.length === 1 ? '1 shader' : `${files.length} shaders`;
  return broken === 0 ? `${all}: no errors.` : `${all}: ${broken} with errors.`;
}
