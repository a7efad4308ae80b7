import type { Binding } from '../../../export/graph/project.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { BRACKET } from './bracket-stops.ts';
import type { Recipe } from './recipe.ts';
import { HANDS, SHOTS } from './room.ts';

interface VideoFilter extends Pick<Recipe, 'folder' | 'figure' | 'title' | 'description'> {
  readonly filter: string;
  readonly params?: Readonly<Record<string, ParamValue>>;
  readonly bindings?: Readonly<Record<string, Binding>>;
}

/** The camera feed through one filter. */
function videoThrough({ filter, params = {}, bindings = {}, ...about }: VideoFilter): Recipe {
  return {
    ...about,
    nodes: { video: ['source/camera-video', 0, 0], filter: [filter, 1, 0, params], screen: ['output/screen', 2, 0] },
    wires: ['video.layer -> filter.inputImage', 'filter.layer -> screen.layer'],
    bindings: Object.fromEntries(Object.entries(bindings).map(([param, binding]) => [`filter.${param}`, binding])),
  };
}

/**
 * Two bracketed photographs as one scene layer: the long exposure, and where it is nearly white the short one, each in the light of the
 * exposure 0. A Tone map then exposes them again.
 */
function exposedBy(stops: number, about: Pick<Recipe, 'folder' | 'figure' | 'title' | 'description'>): Recipe {
  return {
    ...about,
    nodes: {
      long: ['source/image-file', 0, 0, { file: 'shot-long' }],
      short: ['source/image-file', 0, 1, { file: 'shot-short' }],
      clipped: ['filter/mask-from-layer', 1, 2, { low: 0.8, high: 0.97 }],
      cut: ['operator/mask', 2, 1],
      corners: ['filter/to-scene', 2, 0],
      outside: ['filter/to-scene', 3, 1],
      darken: ['filter/hdr-exposure', 3, 0, { stops: -BRACKET.long }],
      brighten: ['filter/hdr-exposure', 4, 1, { stops: -BRACKET.short }],
      merge: ['operator/over', 5, 0],
      expose: ['filter/tone-map', 6, 0, { curve: 4, stops }],
      screen: ['output/screen', 7, 0],
    },
    wires: [
      'long.layer -> clipped.inputImage',
      'short.layer -> cut.inputImage',
      'clipped.layer -> cut.mask',
      'long.layer -> corners.inputImage',
      'cut.layer -> outside.inputImage',
      'corners.layer -> darken.inputImage',
      'outside.layer -> brighten.inputImage',
      'darken.layer -> merge.bottom',
      'brighten.layer -> merge.top',
      'merge.layer -> expose.inputImage',
      'expose.layer -> screen.layer',
    ],
    assets: SHOTS,
  };
}

/** Examples of filters on the camera feed. */
export const FILTERS: readonly Recipe[] = [
  videoThrough({
    folder: 'warm-and-cold-light',
    figure: '8',
    title: 'From warm to cold light',
    description: 'Keyframes change the white balance of the room from candlelight to shade and back.',
    filter: 'filter/color-temperature',
    bindings: {
      temperature: {
        track: {
          keys: [
            { timeS: 0, value: 3600, easing: 'ease-in-out' },
            { timeS: 2, value: 6500, easing: 'ease-in-out' },
            { timeS: 4, value: 12000, easing: 'ease-in-out' },
          ],
          repeat: 'mirror',
        },
      },
    },
  }),
  videoThrough({
    folder: 'black-and-white-threshold',
    figure: '12d',
    title: 'Black and white',
    description: 'Areas that are darker than a level become ink, the others paper.',
    filter: 'filter/threshold',
    params: { level: 0.42, softness: 0.08 },
  }),
  videoThrough({
    folder: 'sepia',
    figure: '12e',
    title: 'Sepia',
    description: 'Shows the room in the brown tones of an old photograph.',
    filter: 'filter/sepia',
  }),
  videoThrough({
    folder: 'radial-blur',
    figure: '12g',
    title: 'Zoom blur',
    description: 'Blurs the room towards one point, as if the camera had zoomed during the exposure.',
    filter: 'filter/radial-blur',
    params: { amount: 0.25 },
  }),
  videoThrough({
    folder: 'spin-blur',
    figure: '12h',
    title: 'Spin blur',
    description: 'Blurs the room around one point, as if the camera had rotated during the exposure.',
    filter: 'filter/spin-blur',
    params: { angle: 0.2 },
  }),
  videoThrough({
    folder: 'swirl',
    figure: '12i',
    title: 'Swirl',
    description: 'Twists the room around its center, back and forth.',
    filter: 'filter/swirl',
    bindings: { angle: { expression: '2.2 + 2.2 * sin(time)' } },
    params: { radius: 900 },
  }),
  exposedBy(-2.6, {
    folder: 'short-exposure',
    figure: '12m',
    title: 'Short exposure',
    description:
      'Two photographs of a room, one exposed for its corners and one for its window, become one image of high dynamic range. With a short exposure the window has its detail, and the room is dark. Change “Exposure” of the Tone map.',
  }),
  exposedBy(1.2, {
    folder: 'long-exposure',
    figure: '12n',
    title: 'Long exposure',
    description:
      'The same two photographs as in “Short exposure”, as one image of high dynamic range. With a long exposure dark corners become visible, and the window and what the sun lights are burnt out.',
  }),
  {
    folder: 'skin-colour',
    figure: '12o',
    title: 'Skin color mask',
    description:
      'Skin of any shade keeps its color; the rest becomes gray. Connect a Camera video node instead of the image and hold up your hand.',
    nodes: {
      picture: ['source/image-file', 0, 0, { file: 'hands-up04' }],
      skin: ['filter/skin-mask', 1, 0],
      grey: ['filter/grey', 1, 1],
      choose: ['operator/choose-by-mask', 2, 0],
      screen: ['output/screen', 3, 0],
    },
    wires: [
      'picture.layer -> skin.inputImage',
      'picture.layer -> grey.inputImage',
      'picture.layer -> choose.inside',
      'grey.layer -> choose.outside',
      'skin.layer -> choose.mask',
      'choose.layer -> screen.layer',
    ],
    assets: HANDS,
  },
  {
    folder: 'near-in-colour-far-in-ink',
    figure: '10b',
    title: 'Near in color, far in ink',
    description:
      'Two effects and a mask: surfaces nearer than 2.75 meters keep their colors; the rest of the room is drawn in ink. Any layer can be the mask.',
    nodes: {
      video: ['source/camera-video', 0, 0],
      depth: ['world/depth', 0, 1],
      ink: ['filter/difference-of-gaussians', 1, 0, { level: 0.45 }],
      near: ['layer/depth-mask', 1, 1, { nearM: 0, farM: 2.75, softnessM: 0.15 }],
      choose: ['operator/choose-by-mask', 2, 0],
      screen: ['output/screen', 3, 0],
    },
    wires: [
      'video.layer -> ink.inputImage',
      'depth.depth -> near.depth',
      'video.layer -> choose.inside',
      'ink.layer -> choose.outside',
      'near.layer -> choose.mask',
      'choose.layer -> screen.layer',
    ],
  },
  {
    folder: 'strokes-on-the-room',
    figure: '10r',
    title: 'Strokes on the room',
    description:
      'The camera video as a hatched drawing whose strokes lie on the real floor, walls and table: they stay there as you walk around. “Medium” makes it charcoal.',
    nodes: {
      video: ['source/camera-video', 0, 0],
      depth: ['world/depth', 0, 1],
      drawing: ['filter/room-drawing', 1, 0],
      screen: ['output/screen', 2, 0],
    },
    wires: ['video.layer -> drawing.inputImage', 'depth.depth -> drawing.room', 'drawing.layer -> screen.layer'],
  },
  {
    folder: 'semaphore',
    figure: '14',
    title: 'Gray room, moving colors',
    description: 'Three filters: gray with more contrast, a slow change of brightness, and a tint whose hue rotates.',
    nodes: {
      video: ['source/camera-video', 0, 0],
      grey: ['filter/grey', 1, 0, { amount: 0.85 }],
      luma: ['filter/luminance-variation', 2, 0, { contrast: 1.5 }],
      chroma: ['filter/chrominance-variation', 3, 0, { saturation: 1.2 }],
      screen: ['output/screen', 4, 0],
    },
    wires: [
      'video.layer -> grey.inputImage',
      'grey.layer -> luma.inputImage',
      'luma.layer -> chroma.inputImage',
      'chroma.layer -> screen.layer',
    ],
    bindings: {
      'luma.brightness': { expression: '0.08 * sin(time)' },
      'chroma.blueYellow': { expression: '0.05 * sin(time / 2)' },
      'chroma.redCyan': { expression: '0.05 * cos(time / 2)' },
    },
  },
];
