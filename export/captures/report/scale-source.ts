/** Where the scale of a capture is from. */
export type ScaleSource =
  /** The user named the meters per unit. */
  | { readonly from: 'given' }
  /** Two points in a photograph, and their distance. */
  | { readonly from: 'distance'; readonly photo: string; readonly meters: number }
  /** A point of the floor in a photograph, and the height of its camera. */
  | { readonly from: 'camera-height'; readonly photo: string; readonly meters: number }
  /** Depth files in meters, which fit the surface. */
  | { readonly from: 'depth' }
  /** A file that says that the units of the cameras are meters. */
  | { readonly from: 'file'; readonly file: string }
  /** Nothing says it: the units of the files are taken as meters. */
  | { readonly from: 'assumed' }
  /** The points that photographs show are taken to be so far away in the median. */
  | { readonly from: 'guessed'; readonly meters: number };

/** Whether fields of JSON are a source of the scale. */
export function isScaleSource({ from, photo, file, meters }: Readonly<Record<string, unknown>>): boolean {
  if (from === 'given' || from === 'depth' || from === 'assumed') return true;
  if (from === 'file') return typeof file === 'string';
  if (from === 'guessed') return Number.isFinite(meters);
  return (from === 'distance' || from === 'camera-height') && typeof photo === 'string' && Number.isFinite(meters);
}

/** Where the scale is from, in words after the scale; and what to do if it may be wrong, else null. */
export function scaleWords(scale: ScaleSource): { readonly text: string; readonly advice: string | null } {
  switch (scale.from) {
    case 'given':
      return { text: 'as given', advice: null };
    case 'distance':
      return { text: `measured: two points in ${scale.photo} are ${scale.meters} m apart`, advice: null };
    case 'camera-height':
      return { text: `measured: the camera of ${scale.photo} is ${scale.meters} m above the floor`, advice: null };
    case 'depth':
      return { text: 'read from the depth files', advice: null };
    case 'file':
      return { text: `read from ${scale.file}`, advice: null };
    case 'assumed':
      return {
        text: 'assumed: the files do not say it',
        advice: `Its units are taken as meters. If the size is wrong, ${TRUE_SIZE}`,
      };
    case 'guessed':
      return {
        text: `guessed: what photographs show is taken to be ${scale.meters} m away`,
        advice: `Its size is a guess. To correct it, ${TRUE_SIZE}`,
      };
  }
}

const TRUE_SIZE =
  'select its node and press “Set scale by two points” under “True size” in the inspector: click two points whose distance you know.';
