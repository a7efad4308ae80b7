import { extname, join } from 'node:path';
import type { FileSink } from '../../../export/bundle/bundle-page.ts';
import { camerasPicture, SIDES } from '../../../export/captures/report/cameras-picture.ts';
import {
  type CaptureReport,
  errorWords,
  photosOf,
  type ReportedPhoto,
  reportFacts,
  scaleAdvice,
  worstFirst,
} from '../../../export/captures/report/capture-report.ts';
import { MARKS_LEGEND, photoMarks } from '../../../export/captures/report/photo-marks.ts';
import type { ImportedCapture } from '../add-capture.ts';
import type { FolderMark } from '../page-folder.ts';
import { readBytes } from '../read-file.ts';
import { page, text } from '../report-html.ts';
import { readCaptureReport } from './read-capture-report.ts';

export const IMPORT_MARK: FolderMark = { file: 'report.json', format: 'scrim-import', words: 'an earlier report' };

const MAX_PHOTO_BYTES = 2 ** 30;
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
 * Writes a page about an import: what it understood, its cameras over the mesh, and where its points were seen in each photograph and where
 * its cameras project them. `report.json` has the figures.
 *
 * @param folder Path of the folder of the capture.
 */
export async function writeImportReport(sink: FileSink, folder: string, imported: ImportedCapture): Promise<void> {
  const report = await readCaptureReport(folder);
  const photos = photosOf(report);
  const files: { readonly path: string }[] = [];
  const write = async (path: string, bytes: Uint8Array): Promise<void> => {
    await sink.write(path, bytes);
    files.push({ path });
  };
  const figures: string[] = [];
  for (const photo of worstFirst(photos)) {
    const { file } = photo.view;
    const path = `views/${String(photo.index).padStart(3, '0')}${extname(file)}`;
    await write(path, await readBytes(join(folder, file), MAX_PHOTO_BYTES));
    figures.push(photoFigure(path, photo));
  }
  const facts = reportFacts(report).map(({ label, text: words }) => `<tr><td>${label}</td><td>${text(words)}</td></tr>`);
  const advice = scaleAdvice(report.record);
  const warnings = [...(advice === null ? [] : [advice]), ...(report.record?.warnings ?? [])].map((warning) => `<p>${text(warning)}</p>`);
  const body = `<table>${facts.join('\n')}</table>
${warnings.join('\n')}
<h2>Cameras over the mesh</h2>
<section class="places">
${camerasFigures(report, photos)}
</section>
<h2>Photographs</h2>
${imported.pointCount > 0 ? `<p>${MARKS_LEGEND}</p>\n` : ''}<section>
${figures.join('\n')}
</section>`;
  await write('index.html', new TextEncoder().encode(page(`${imported.path.split('/').at(-2) ?? ''}, imported`, body, STYLE)));
  const json = { format: IMPORT_MARK.format, version: 1, ...imported, files };
  await sink.write(IMPORT_MARK.file, new TextEncoder().encode(`${JSON.stringify(json, null, 1)}\n`));
}

function camerasFigures({ surface, views }: CaptureReport, photos: readonly ReportedPhoto[]): string {
  const figures = SIDES.map((side) => {
    const { viewBox, mesh, cameras } = camerasPicture(side, surface, views);
    const drawn = cameras.map((d, i) => `<path class="camera" d="${d}"><title>${text(photos[i]?.name ?? '')}</title></path>`);
    return `<figure><svg viewBox="${viewBox}" role="img" aria-label="${side.caption}"><path class="mesh" d="${mesh}"/>${drawn.join('')}</svg><figcaption>${side.caption}</figcaption></figure>`;
  });
  return figures.join('\n');
}

function photoFigure(path: string, { view: { widthPx, heightPx }, about, name }: ReportedPhoto): string {
  const { seen, off } = photoMarks(about?.places ?? []);
  const overlay = `<svg viewBox="0 0 ${widthPx} ${heightPx}" aria-hidden="true"><path class="seen" d="${seen}"/><path class="off" d="${off}"/></svg>`;
  return `<figure><div class="photo"><img src="${path}" alt="${text(name)}" loading="lazy">${overlay}</div><figcaption>${text(`${name}: ${errorWords(about)}`)}</figcaption></figure>`;
}
