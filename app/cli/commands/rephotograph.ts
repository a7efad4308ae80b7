import { join } from 'node:path';
import { REPHOTOGRAPH_METHODS, type RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import { CAPTURE_FILE } from '../../../nodes/kit/capture.ts';
import { realFolder } from '../../services/confine.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { writePageFolder } from '../../services/page-folder.ts';
import {
  createRephotographReport,
  methodsOf,
  REPHOTOGRAPH_MARK,
  readRephotographed,
} from '../../services/rephotograph/rephotograph-report.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import { rephotographViews } from '../rephotograph/rephotograph-views.ts';

const DEFAULT_BLENDED = 2;
const MOST_BLENDED = 4;

export const rephotographCommand: Command = {
  name: 'rephotograph',
  usage: 'FOLDER --out DIR [--method METHOD] [--blended N]',
  summary: 'Measure how well a capture shows its photographs',
  doc: 'Renders each photograph of a capture from all others, and compares the two: the difference in dB (PSNR), the structural similarity (SSIM), and the error of the colors (Cb and Cr). Writes a page with all pictures and a file with all figures to DIR, and prints the means. The methods are those of the node Capture.',
  project: 'required',
  operand: { word: 'FOLDER', doc: 'the folder of a capture, assets/NAME.capture in a project' },
  options: {
    out: { type: 'string', value: 'DIR', doc: 'Folder for index.html, report.json and the pictures.' },
    method: {
      type: 'string',
      value: 'METHOD',
      doc: `Only this method: ${REPHOTOGRAPH_METHODS.join(', ')}. Default: all, depth-meshes if the capture has them.`,
    },
    blended: {
      type: 'string',
      value: 'N',
      doc: `Photographs per pixel of the lumigraph, 1 to ${MOST_BLENDED}. Default: ${DEFAULT_BLENDED}.`,
    },
  },
  examples: [
    { line: 'scrim rephotograph my-room/assets/kitchen.capture --out report', says: 'Compares all methods.' },
    { line: 'scrim rephotograph my-room/assets/vase.capture --out report --method lumigraph --blended 3', says: 'One method only.' },
  ],
  run: async (call, { installation, say, interrupted }) => {
    const out = call.text('out');
    if (!out) throw new UsageError('--out DIR is missing. Name the folder for the report.');
    const named = methodOf(call);
    const blended = blendedOf(call);
    const folder = await folderOf(call.project);
    const document = await readRephotographed(folder);
    const methods = named === null ? methodsOf(document) : [named];
    const written = await writePageFolder(
      out,
      NODE_FILES,
      async (sink) => {
        const report = createRephotographReport(sink, folder, document, blended);
        await rephotographViews({ root: installation.root, folder, methods, blended, say, interrupted, onView: report.add });
        return { means: await report.finish(), views: report.views };
      },
      REPHOTOGRAPH_MARK,
    );
    const { means, views } = written ?? { means: [], views: [] };
    const lines = means.map(
      ({ method, psnrDb, ssim, chromaError }) =>
        `  ${method.padEnd(12)}  ${psnrDb.toFixed(2)} dB, SSIM ${ssim.toFixed(3)}, color error ${chromaError.toFixed(2)}`,
    );
    const text = [`Rendered ${views.length} photographs, each from the others. Means:`, ...lines, `Wrote ${join(out, 'index.html')}`];
    return { status: 0, json: { ok: true, out, means, views }, text: text.join('\n'), diagnostics: [] };
  },
};

function methodOf(call: Call): RephotographMethod | null {
  const named = call.text('method');
  const method = REPHOTOGRAPH_METHODS.find((known) => known === named);
  if (named !== null && !method)
    throw new UsageError(`--method needs one of ${REPHOTOGRAPH_METHODS.join(', ')}, not ${JSON.stringify(named)}.`);
  return method ?? null;
}

function blendedOf(call: Call): number {
  const text = call.text('blended');
  const value = text === null ? DEFAULT_BLENDED : Number(text);
  if (!Number.isInteger(value) || value < 1 || value > MOST_BLENDED) {
    throw new UsageError(`--blended needs a whole number from 1 to ${MOST_BLENDED}, not ${JSON.stringify(text)}.`);
  }
  return value;
}

async function folderOf(path: string): Promise<string> {
  const folder = path.endsWith(`/${CAPTURE_FILE}`) ? path.slice(0, -CAPTURE_FILE.length - 1) : path;
  return realFolder(folder);
}
