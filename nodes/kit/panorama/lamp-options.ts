/** How a panorama is searched: the params of “Lights from panorama” that change the result. */
export interface LampOptions {
  readonly method: 'paper' | 'solid-angle';
  /** Maximum number of lamps. */
  readonly lamps: number;
  /** Of `paper`: how often the search repeats. */
  readonly iterations: number;
  /** Of `paper`. */
  readonly intensities: 'ranks' | 'area';
  /** Of `solid-angle`: the part of all light that clipped pixels give. */
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

/** The name of a result among those of a panorama: equal for options that give equal results. */
export function lampKey({ method, lamps, iterations, intensities, clippedShare }: LampOptions): string {
  return method === 'paper' ? `paper ${lamps} ${iterations} ${intensities}` : `solid-angle ${lamps} ${clippedShare}`;
}
