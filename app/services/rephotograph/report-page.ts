import type { ImageQuality } from '../../../export/captures/evaluate/image-quality.ts';
import type { RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import { fixed, page, text } from '../report-html.ts';

/** The figures of one view by one method, and its pictures, as paths relative to the report. */
export interface ReportedShot extends ImageQuality {
  readonly method: RephotographMethod;
  readonly picture: string;
  readonly error: string;
}

export interface ReportedView {
  /** Name of the photograph in the capture. */
  readonly file: string;
  readonly photo: string;
  readonly shots: readonly ReportedShot[];
}

/** The mean over views of each figure by one method. */
export interface MethodMeans extends ImageQuality {
  readonly method: RephotographMethod;
}

/** The mean over views of each figure, by method. */
export function meansOf(views: readonly ReportedView[]): readonly MethodMeans[] {
  const methods = views[0]?.shots.map(({ method }) => method) ?? [];
  return methods.map((method) => {
    const shots = views.flatMap((view) => view.shots.filter((shot) => shot.method === method));
    const mean = (figure: keyof ImageQuality): number => {
      const values = shots.map((shot) => shot[figure]).filter(Number.isFinite);
      return values.reduce((sum, value) => sum + value, 0) / values.length;
    };
    return { method, psnrDb: mean('psnrDb'), ssim: mean('ssim'), chromaError: mean('chromaError'), covered: mean('covered') };
  });
}

/** The page of a report, with pictures: the photograph, and each method’s picture and error. */
export function reportPage(title: string, views: readonly ReportedView[]): string {
  const means = meansOf(views);
  const head = ['View', ...means.map(({ method }) => `${capital(method)}, dB`), ...means.map(({ method }) => `${capital(method)}, SSIM`)];
  const rows = views.map(({ file, shots }) => [
    file,
    ...shots.map(({ psnrDb }) => fixed(psnrDb, 2)),
    ...shots.map(({ ssim }) => fixed(ssim, 3)),
  ]);
  const last = ['Mean', ...means.map(({ psnrDb }) => fixed(psnrDb, 2)), ...means.map(({ ssim }) => fixed(ssim, 3))];
  return page(
    title,
    `<p>Each photograph, rendered from all others at its own size. Figures are over the pixels that the mesh covers; pixels of 360° photographs count by the angle that they show. Error maps show |ΔCb| + |ΔCr|: dark blue is 0, yellow 25.5 or more of 255.</p>
<table>
<tr>${head.map((cell) => `<th>${text(cell)}</th>`).join('')}</tr>
${[...rows, last].map((row) => `<tr>${row.map((cell) => `<td>${text(cell)}</td>`).join('')}</tr>`).join('\n')}
</table>
${views.map(viewSection).join('\n')}`,
  );
}

function viewSection({ file, photo, shots }: ReportedView): string {
  const figures = [
    figure(photo, `Photograph ${file}`),
    ...shots.flatMap(({ method, picture, error, psnrDb, chromaError }) => [
      figure(picture, `${capital(method)}: ${fixed(psnrDb, 2)} dB`),
      figure(error, `${capital(method)}, error: mean ${fixed(chromaError, 2)}`),
    ]),
  ];
  return `<h2>${text(file)}</h2>\n<section>\n${figures.join('\n')}\n</section>`;
}

function figure(source: string, caption: string): string {
  return `<figure><img src="${text(source)}" alt="${text(caption)}" loading="lazy"><figcaption>${text(caption)}</figcaption></figure>`;
}

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1).replace('-', ' ');
}
