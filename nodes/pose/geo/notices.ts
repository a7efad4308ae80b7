import type { GeoRefusal } from './locate.ts';

interface Words {
  readonly message: string;
  readonly fix: string;
}

const NOT_SHOWN = 'Things at places on Earth are not shown.';

/** The texts that tell the visitor why there is no location. */
export const REFUSALS: Readonly<Record<GeoRefusal, Words>> = {
  denied: { message: `The location was not allowed. ${NOT_SHOWN}`, fix: 'Allow it beside the address bar, then reload the page.' },
  unavailable: { message: `This device does not know its location. ${NOT_SHOWN}`, fix: 'Turn on location in the settings of the device.' },
  timeout: { message: 'The location is not known yet. The search continues.', fix: 'Go outdoors, or wait.' },
  absent: { message: `The location cannot be used here. ${NOT_SHOWN}`, fix: 'Open the page over HTTPS.' },
};

export const NO_NORTH: Words = {
  message: 'This device has no compass. Things at places on Earth appear once a walk in AR has shown where north is.',
  fix: 'Walk straight on, or open the page on a phone with a compass.',
};

export const NORTH_DENIED: Words = {
  message: 'The compass was not allowed. Things at places on Earth appear once a walk in AR has shown where north is.',
  fix: 'Walk straight on. To allow the compass, close this tab and open the page again.',
};

/**
 * The text that tells the visitor that the location is too inaccurate.
 *
 * @param errorM The current accuracy, meters.
 */
export function inaccurate(errorM: number, largestM: number): Words {
  const known = Number.isFinite(errorM) ? `accurate to ${Math.round(errorM)} m only` : 'too inaccurate';
  return {
    message: `The location is ${known}. Things at places on Earth appear from ${Math.round(largestM)} m on.`,
    fix: 'Go outdoors, away from high walls and from metal.',
  };
}
