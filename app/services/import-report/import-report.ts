import { extname, join } from 'node:path';
import type { FileSink } from '../../../export/bundle/bundle-page.ts';
import { reprojectedPlaces } from '../../../export/captures/source-view.ts';
import { CAPTURE_FILE, type CaptureView, readCapture, readCaptureMesh } from '../../../nodes/kit/capture.ts';
import type { ImportedCapture, ImportedView } from '../add-capture.ts';
import type { FolderMark } from '../page-folder.ts';
import type { FoundView } from '../read-capture-folder.ts';
import { readBytes, readText } from '../read-file.ts';
import { fixed, page, text } from '../report-html.ts';
import { camerasPictures } from './cameras-picture.ts';

export const IMPORT_MARK: FolderMark = { file: 'report.json', format: 'scrim-import', words: 'an earlier report' };

const MAX_CAPTURE_BYTES = 16 * 2 ** 20;
const MAX_FILE_BYTES = 2 ** 30;
/** Errors are drawn so many times as long as they are. */
const LONGER = 10;
/** Points that are drawn in a photograph. */
const MOST_POINTS = 1500;
const LEGEND = `<p>Blue: where a point of the reconstruction was seen. Red: towards where the camera projects it, ${LONGER} times as long as the error.</p>\n`;
const STYLE = `
svg { display: block; width: 100%; overflow: hidden; }
.places figure { width: 26rem; }
.mesh { stroke: #98a3b1; stroke-width: 4.5; stroke-linecap: round; fill: none; }
.camera { stroke: #ffb454; stroke-width: 2.5; stroke-linejoin: round; fill: #ffb45422; }
.photo { position: relative; }
.photo svg { position: absolute; inset: 0; }
.seen { stroke: #39d0ff; stroke-width: 4; stroke-linecap: round; }
.off { stroke: #ff3d71; stroke-width: 1.5; fill: none; }
.seen, .off { vector-effect: non-scaling-stroke; }`;

/**
 * Writes a page about an import: its cameras over the mesh, and where its points were seen in each photograph and where its cameras project
 * them. `report.json` has the figures.
 *
 * @param folder Path of the folder of the capture.
 * @param sources The photographs and their cameras, in the order of the capture.
 */
export async function writeImportReport(
  sink: FileSink,
  folder: string,
  imported: ImportedCapture,
  sources: readonly FoundView[],
): Promise<void> {
  const document = readCapture(await readText(join(folder, CAPTURE_FILE), MAX_CAPTURE_BYTES));
  const mesh = readCaptureMesh(document.mesh, (await readBytes(join(folder, document.mesh.file), MAX_FILE_BYTES)).buffer);
  const files: { readonly path: string }[] = [];
  const write = async (path: string, bytes: Uint8Array): Promise<void> => {
    await sink.write(path, bytes);
    files.push({ path });
  };
  const figures: string[] = [];
  for (const [i, view] of document.views.entries()) {
    const path = `views/${String(i).padStart(3, '0')}${extname(view.file)}`;
    await write(path, await readBytes(join(folder, view.file), MAX_FILE_BYTES));
    const [source, about] = [sources[i], imported.views[i]];
    if (source && about) figures.push(photoFigure(path, view, source, about));
  }
  const names = imported.views.map(({ photo }) => photo);
  const body = `<p>${text(summaryOf(imported))}</p>
<h2>Cameras over the mesh</h2>
<section class="places">
${camerasPictures(document, mesh, names)}
</section>
<h2>Photographs</h2>
${imported.pointCount > 0 ? LEGEND : ''}<section>
${figures.join('\n')}
</section>`;
  await write('index.html', new TextEncoder().encode(page(`${imported.path.split('/').at(-2) ?? ''}, imported`, body, STYLE)));
  const report = { format: IMPORT_MARK.format, version: 1, ...imported, files };
  await sink.write(IMPORT_MARK.file, new TextEncoder().encode(`${JSON.stringify(report, null, 1)}\n`));
}

function summaryOf({ form, views, pointCount, triangleCount, sizeM, up, diagnostics }: ImportedCapture): string {
  const size = sizeM.map((m) => m.toFixed(2)).join(' × ');
  const facts = `From ${form}: ${views.length === 1 ? '1 photograph' : `${views.length} photographs`}, ${pointCount} points, a mesh of ${triangleCount} triangles and ${size} m. Up is the ${up} axis of the reconstruction.`;
  return [facts, ...diagnostics.map(({ message }) => message)].join(' ');
}

function photoFigure(path: string, view: CaptureView, { view: source, lens }: FoundView, { photo, errorPx, points }: ImportedView): string {
  const { widthPx, heightPx } = view;
  const places = reprojectedPlaces(source, lens, view);
  const step = Math.max(1, Math.ceil(places.length / 4 / MOST_POINTS));
  let [seen, off] = ['', ''];
  for (let i = 0; i < places.length; i += 4 * step) {
    const [x = 0, y = 0, toX = 0, toY = 0] = places.slice(i, i + 4);
    const from = `M${x.toFixed(1)} ${y.toFixed(1)}`;
    seen += `${from}h0`;
    off += `${from}l${(LONGER * (toX - x)).toFixed(1)} ${(LONGER * (toY - y)).toFixed(1)}`;
  }
  const caption = `${photo}: ${errorPx === null ? 'no points' : `${fixed(errorPx, 2)} px over ${points} points`}`;
  const overlay = `<svg viewBox="0 0 ${widthPx} ${heightPx}" aria-hidden="true"><path class="seen" d="${seen}"/><path class="off" d="${off}"/></svg>`;
  return `<figure><div class="photo"><img src="${path}" alt="${text(photo)}" loading="lazy">${overlay}</div><figcaption>${text(caption)}</figcaption></figure>`;
}
