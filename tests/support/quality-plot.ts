/** PSNR of what a page shows while it loads: a step function of time. */
export interface LoadingCurve {
  readonly steps: readonly { readonly timeS: number; readonly psnrDb: number }[];
  /** PSNR when all is loaded. */
  readonly finalDb: number;
}

export interface MeanCurve extends LoadingCurve {
  /** When every curve has begun, and when their mean reaches 90 % of its end. Seconds. */
  readonly firstS: number;
  readonly ninetyS: number;
}

/** The mean of curves from when all of them have begun. */
export function meanCurve(curves: readonly LoadingCurve[]): MeanCurve {
  const firstS = Math.max(...curves.map(({ steps }) => steps[0]?.timeS ?? Number.POSITIVE_INFINITY));
  const times = [...new Set(curves.flatMap(({ steps }) => steps.map(({ timeS }) => timeS)))].filter((timeS) => timeS >= firstS);
  const steps = times
    .sort((a, b) => a - b)
    .map((timeS) => ({
      timeS,
      psnrDb: mean(curves.map((curve) => curve.steps.filter((step) => step.timeS <= timeS).at(-1)?.psnrDb ?? 0)),
    }));
  const finalDb = mean(curves.map((curve) => curve.finalDb));
  const ninetyS = steps.find(({ psnrDb }) => psnrDb >= 0.9 * finalDb)?.timeS ?? Number.POSITIVE_INFINITY;
  return { steps, finalDb, firstS, ninetyS };
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

const [WIDTH, HEIGHT] = [720, 360];
const FRAME = { left: 58, right: 16, top: 16, bottom: 46 } as const;
const TICK_DB = 5;

/** Draws the mean of curves over each of them as an SVG file, with a line at 90 % of its end. */
export function plotQuality(curves: readonly LoadingCurve[], about: { readonly title: string; readonly description: string }): string {
  const { steps, finalDb, firstS, ninetyS } = meanCurve(curves);
  const endS = Math.ceil(Math.max(...curves.map((curve) => curve.steps.at(-1)?.timeS ?? 0)));
  const all = curves.flatMap((curve) => [curve.finalDb, ...curve.steps.map(({ psnrDb }) => psnrDb)]);
  const [leastDb, mostDb] = [TICK_DB * Math.floor(Math.min(...all) / TICK_DB), TICK_DB * Math.ceil(Math.max(...all) / TICK_DB)];
  const x = (timeS: number): string => (FRAME.left + (timeS / endS) * (WIDTH - FRAME.left - FRAME.right)).toFixed(1);
  const y = (db: number): string =>
    (HEIGHT - FRAME.bottom - ((db - leastDb) / (mostDb - leastDb)) * (HEIGHT - FRAME.top - FRAME.bottom)).toFixed(1);
  const line = ({ steps: points, finalDb: last }: LoadingCurve): string => {
    const [first, ...more] = points;
    if (!first) return '';
    return `M${x(first.timeS)} ${y(first.psnrDb)}${more.map(({ timeS, psnrDb }) => `H${x(timeS)}V${y(psnrDb)}`).join('')}V${y(last)}H${x(endS)}`;
  };
  const right = WIDTH - FRAME.right;
  const bottom = HEIGHT - FRAME.bottom;
  const ticksX = Array.from({ length: endS + 1 }, (_, s) => `<text x="${x(s)}" y="${bottom + 18}" text-anchor="middle">${s}</text>`);
  const ticksY = Array.from({ length: (mostDb - leastDb) / TICK_DB + 1 }, (_, i) => leastDb + i * TICK_DB).map(
    (db) =>
      `<path class="grid" d="M${FRAME.left} ${y(db)}H${right}"/><text x="${FRAME.left - 8}" y="${y(db)}" dy="4" text-anchor="end">${db}</text>`,
  );
  const [ninetyX, ninetyY] = [x(ninetyS), y(0.9 * finalDb)];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-labelledby="title description" font-family="sans-serif" font-size="13">
<title id="title">${about.title}</title>
<desc id="description">${about.description} The mean begins at ${firstS.toFixed(1)} s with ${(steps[0]?.psnrDb ?? 0).toFixed(1)} dB, reaches 90 % of its end at ${ninetyS.toFixed(1)} s, and ends at ${finalDb.toFixed(1)} dB.</desc>
<style>.grid{stroke:#ddd}.one{stroke:#8fb4e3;stroke-width:1;fill:none}.mean{stroke:#0b57a4;stroke-width:3;fill:none}.ninety{stroke:#b3261e;stroke-width:1.5;stroke-dasharray:6 4}.late{fill:#b3261e}</style>
<rect width="${WIDTH}" height="${HEIGHT}" fill="#fff"/>
${ticksY.join('\n')}
${ticksX.join('\n')}
<path stroke="#444" fill="none" d="M${FRAME.left} ${FRAME.top}V${bottom}H${right}"/>
<text x="${(FRAME.left + right) / 2}" y="${HEIGHT - 8}" text-anchor="middle">Time since the first request (s)</text>
<text transform="translate(16 ${(FRAME.top + bottom) / 2}) rotate(-90)" text-anchor="middle">PSNR (dB)</text>
${curves.map((curve) => `<path class="one" d="${line(curve)}"/>`).join('\n')}
<path class="mean" d="${line({ steps, finalDb })}"/>
<path class="ninety" d="M${FRAME.left} ${ninetyY}H${right}M${ninetyX} ${ninetyY}V${bottom}"/>
<text class="late" x="${ninetyX}" y="${bottom}" dx="8" dy="-12">90 % of the end: ${(0.9 * finalDb).toFixed(1)} dB, after ${ninetyS.toFixed(1)} s</text>
</svg>
`;
}
