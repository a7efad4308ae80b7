import { basename, extname, join } from 'node:path';
import { CAPTURE_FILE, CaptureError, readCapture } from '../../../nodes/kit/capture.ts';
import { realFolder } from '../../services/confine.ts';
import { errorCode, refusal } from '../../services/file-errors.ts';
import { NODE_FILES } from '../../services/file-layer.ts';
import { type FolderMark, writePageFolder } from '../../services/page-folder.ts';
import { readBytes, readText } from '../../services/read-file.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import type { Method } from '../rephotograph/rephotograph.page.ts';
import { rephotographViews } from '../rephotograph/rephotograph-views.ts';
import { meansOf, type ReportedView, reportPage } from '../rephotograph/report-page.ts';

const METHODS: readonly Method[] = ['plain', 'nearest', 'lumigraph', 'depth-meshes'];
const DEFAULT_BLENDED = 2;
const MOST_BLENDED = 4;
const REPORT: FolderMark = { file: 'report.json', format: 'scrim-rephotograph', words: 'an earlier report' };
const MAX_CAPTURE_BYTES = 16 * 2 ** 20;
const MAX_PHOTO_BYTES = 256 * 2 ** 20;

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
      doc: `Only this method: ${METHODS.join(', ')}. Default: all, depth-meshes if the capture has them.`,
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
    const { views: photos } = await documentOf(folder);
    const hasDepthMeshes = photos.some(({ depthMesh }) => depthMesh);
    const methods = named === null ? METHODS.filter((method) => method !== 'depth-meshes' || hasDepthMeshes) : [named];
    const title = `${basename(folder).replace(/\.capture$/, '')}, rephotographed`;
    const views: ReportedView[] = [];
    await writePageFolder(
      out,
      NODE_FILES,
      async (sink) => {
        const files: { readonly path: string }[] = [];
        const write = async (path: string, bytes: Uint8Array): Promise<string> => {
          await sink.write(path, bytes);
          files.push({ path });
          return path;
        };
        await rephotographViews({
          root: installation.root,
          folder,
          methods,
          blended,
          keepsPictures: true,
          say,
          interrupted,
          onView: async (index, shots) => {
            // 360° photographs are not rendered, but serve the others.
            if (shots.length === 0) return;
            const file = photos[index]?.file ?? '';
            const stem = `views/${String(index).padStart(3, '0')}`;
            const photo = await write(`${stem}${extname(file)}`, await readBytes(join(folder, file), MAX_PHOTO_BYTES));
            const reported = [];
            for (const { picture, error, ...shot } of shots) {
              reported.push({
                ...shot,
                picture: await write(`${stem}-${shot.method}.png`, bytesOf(picture)),
                error: await write(`${stem}-${shot.method}-error.png`, bytesOf(error)),
              });
            }
            views.push({ file, photo, shots: reported });
          },
        });
        await write('index.html', new TextEncoder().encode(reportPage(title, views)));
        const report = { format: REPORT.format, version: 1, blended, means: meansOf(views), views, files };
        await sink.write(REPORT.file, new TextEncoder().encode(`${JSON.stringify(report, null, 1)}\n`));
        return true;
      },
      REPORT,
    );
    const means = meansOf(views);
    const lines = means.map(
      ({ method, psnrDb, ssim, chromaError }) =>
        `  ${method.padEnd(12)}  ${psnrDb.toFixed(2)} dB, SSIM ${ssim.toFixed(3)}, color error ${chromaError.toFixed(2)}`,
    );
    const text = [`Rendered ${views.length} photographs, each from the others. Means:`, ...lines, `Wrote ${join(out, 'index.html')}`];
    return { status: 0, json: { ok: true, out, means, views }, text: text.join('\n'), diagnostics: [] };
  },
};

function methodOf(call: Call): Method | null {
  const named = call.text('method');
  const method = METHODS.find((known) => known === named);
  if (named !== null && !method) throw new UsageError(`--method needs one of ${METHODS.join(', ')}, not ${JSON.stringify(named)}.`);
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

async function documentOf(folder: string) {
  try {
    const document = readCapture(await readText(join(folder, CAPTURE_FILE), MAX_CAPTURE_BYTES));
    if (document.views.every(({ projection }) => projection))
      throw new CaptureError('it has 360° photographs only, which no flat picture shows');
    if (document.views.length < 2) throw new CaptureError('it has one photograph only, and none is left to render it from');
    return document;
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR032', `${folder} cannot be rephotographed: ${error.message}.`);
    if (errorCode(error) !== 'ENOENT') throw error;
    throw refusal('SCR032', `${folder} is not a capture: it has no ${CAPTURE_FILE}.`, 'Name a folder assets/NAME.capture of a project.');
  }
}

function bytesOf(dataUrl: string | null): Uint8Array {
  return Buffer.from(dataUrl?.slice(dataUrl.indexOf(',') + 1) ?? '', 'base64');
}
