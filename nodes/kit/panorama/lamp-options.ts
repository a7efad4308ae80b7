/** How a panorama is searched: the params of “Lights from panorama” that change the result. */
export interface LampOptions {
  readonly method: 'paper' | 'solid-angle';
  /** Maximum number of lamps. */
  readonly lamps: number;
  /** Only for the method `paper`: how often the search repeats. */
  readonly iterations: number;
  /** Only for the method `paper`: how the intensities of lamps are chosen, see `PaperOptions`. */
  readonly intensities: 'ranks' | 'area';
  /** Only for the method `solid-angle`: the fraction of all light that clipped pixels are assumed to give. */
  readonly clippedShare: number;
}

/**
 * Reads the options from the values of the node's params.
 *
 * @example
 * const options = lampOptionsOf(ctx.config);
 */
export function lampOptionsOf(values: Readonly<Record<keyof LampOptions, unknown>>): LampOptions {
  return {
    method: values.method === 'paper' ? 'paper' : 'solid-angle',
    lamps: Number(values.lamps),
    iterations: Number(values.iterations),
    intensities: values.intensities === 'area' ? 'area' : 'ranks',
    clippedShare: Number(values.clippedShare),
  };
}

/**
 * The key under which a result of a panorama is stored: equal for options that give equal results.
 *
 * @example
 * lampKey({ method: 'solid-angle', lamps: 3, iterations: 2, intensities: 'ranks', clippedShare: 0.5 }); // 'solid-angle 3 0.5'
 */
export function lampKey({ method, lamps, iterations, intensities, clippedShare }: LampOptions): string {
  return method === 'paper' ? `paper ${lamps} ${iterations} ${intensities}` : `solid-angle ${lamps} ${clippedShare}`;
}

/** Shots of one panorama that “Panorama from exposures” merges: the ids of their assets, and its param “Stops apart”. */
export interface Exposures {
  readonly shots: readonly string[];
  readonly stopsApart: number;
}

/**
 * The beginning of the keys under which the asset of the first shot stores the lamps of the merged panorama; `lampKey` follows.
 *
 * @example
 * exposuresKey({ shots: ['bright', 'dark'], stopsApart: 0 }); // 'bright + dark, 0: '
 */
export function exposuresKey({ shots, stopsApart }: Exposures): string {
  return `${shots.join(' + ')}, ${stopsApart}: `;
}

/**
 * Selects the lamps of a merged panorama from those that the asset of its first shot stores.
 *
 * @example
 * const lamps = lampsOfExposures(first.lamps, { shots: ['bright', 'dark'], stopsApart: 0 });
 */
export function lampsOfExposures<T>(stored: Readonly<Record<string, T>> | undefined, exposures: Exposures): Readonly<Record<string, T>> {
  const start = exposuresKey(exposures);
  const own = Object.entries(stored ?? {}).filter(([key]) => key.startsWith(start));
  return Object.fromEntries(own.map(([key, lamps]) => [key.slice(start.length), lamps]));
}
