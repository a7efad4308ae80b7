import type { Binding } from '../../../export/graph/project.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { Recipe } from './recipe.ts';
import { HANDS } from './room.ts';

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
    params: { radius: 260 },
  }),
  videoThrough({
    folder: 'short-exposure',
    figure: '12m',
    title: 'Short exposure',
    description: 'A short exposure: the window keeps its detail, and the room becomes dark.',
    filter: 'filter/hdr-exposure',
    params: { stops: -1.6 },
  }),
  videoThrough({
    folder: 'long-exposure',
    figure: '12n',
    title: 'Long exposure',
    description: 'A long exposure: dark corners become visible, and bright areas are compressed instead of clipped.',
    filter: 'filter/hdr-exposure',
    params: { stops: 1.6, highlights: 0.6 },
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
