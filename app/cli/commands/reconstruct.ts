import { realFolder } from '../../services/confine.ts';
import { COLMAP, findTool } from '../../services/outside/outside-tools.ts';
import { reconstruct } from '../../services/reconstruct/reconstruct-photographs.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import { quoted } from '../quoted.ts';

export const reconstructCommand: Command = {
  name: 'reconstruct',
  usage: 'FOLDER',
  summary: 'Find the cameras of photographs, with COLMAP',
  doc: `Runs COLMAP (${COLMAP.url}) on the photographs in FOLDER or FOLDER/images, and writes their cameras to FOLDER/sparse. Where COLMAP was built with CUDA, it also computes depth and a mesh (FOLDER/dense); elsewhere, a rough mesh of the points that photographs share (FOLDER/sparse/0/mesh.ply). scrim import capture reads both. Everything that COLMAP prints is in FOLDER/.scrim-reconstruction/colmap.log. After an interrupt, the same command continues with the step that was interrupted. One process works on a folder at a time.`,
  project: 'required',
  operand: { word: 'FOLDER', doc: 'the folder with the photographs' },
  options: {
    colmap: {
      type: 'string',
      value: 'PATH',
      doc: `The executable file of COLMAP. Default: that of the environment variable ${COLMAP.setting}, else colmap in PATH.`,
    },
    lenses: {
      type: 'string',
      value: 'one|many',
      doc: 'Whether one camera with one focal length took all photographs. Default: one.',
    },
    dense: {
      type: 'string',
      value: 'yes|no',
      doc: 'Whether to compute depth, for a fine mesh. Default: where COLMAP was built with CUDA.',
    },
  },
  examples: [
    { line: 'scrim reconstruct scans/kitchen', says: 'Finds the cameras of scans/kitchen/images.' },
    { line: 'scrim reconstruct scans/kitchen --colmap /opt/colmap/bin/colmap --dense no', says: 'With a certain COLMAP, without depth.' },
  ],
  run: async (call, { say, interrupted }) => {
    const oneCamera = choice(call, 'lenses', ['one', 'many']) !== 'many';
    const dense = choice(call, 'dense', ['yes', 'no']);
    const colmap = await findTool(COLMAP, call.text('colmap'));
    const folder = await realFolder(call.project);
    const result = await reconstruct({ folder, colmap, oneCamera, dense: dense && dense === 'yes', say, interrupted });
    const { photographs, found, mesh, isDense, kept, diagnostics } = result;
    const lines = [
      `Found the cameras of ${found} of ${photographs} photographs.`,
      ...(kept.length > 0 ? [`Already done: ${kept.join(', ')}.`] : []),
      meshWords(mesh, isDense),
      `Next: scrim import capture ${quoted(isDense ? `${call.project}/dense/0` : call.project)} --project PROJECT`,
    ];
    return { status: 0, json: { ok: true, ...result }, text: lines.join('\n'), diagnostics };
  },
};

function meshWords(mesh: string | null, isDense: boolean): string {
  if (mesh === null) return 'The folder has depth or a mesh already.';
  return isDense ? `Wrote the mesh ${mesh}.` : `Wrote the mesh ${mesh}: a rough one of points, because COLMAP needs CUDA for depth.`;
}

function choice<T extends string>(call: Call, option: string, words: readonly T[]): T | null {
  const text = call.text(option);
  const found = words.find((word) => word === text);
  if (text !== null && !found) throw new UsageError(`--${option} needs ${words.join(' or ')}, not ${JSON.stringify(text)}.`);
  return found ?? null;
}
