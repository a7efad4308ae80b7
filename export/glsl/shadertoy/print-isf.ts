import { withoutChannelDirectives } from './read-pasted.ts';
import { wordsOf } from './rename-words.ts';
import { fresh, separateTabs } from './separate-tabs.ts';
import { type BufferLetter, CHANNEL_COUNT, type Channel, type Shadertoy, type Tab, tabName } from './shadertoy.ts';

/** ISF expressions for the site's variables, in printing order; `MOUSE` is the name of the input. */
const VARIABLES: Readonly<Record<string, string>> = {
  iResolution: 'vec3(RENDERSIZE, 1.0)',
  iTime: 'TIME',
  iGlobalTime: 'TIME',
  iTimeDelta: 'TIMEDELTA',
  iFrame: 'FRAMEINDEX',
  iFrameRate: '(TIMEDELTA > 0.0 ? 1.0 / TIMEDELTA : 60.0)',
  // Months count from 0 there, from 1 in ISF.
  iDate: '(DATE - vec4(0.0, 1.0, 0.0, 0.0))',
  iMouse: 'vec4(MOUSE * RENDERSIZE, MOUSE * RENDERSIZE)',
  iSampleRate: '44100.0',
  iChannelTime: 'float[4](TIME, TIME, TIME, TIME)',
};

/** Names of ISF that no input or pass can have. */
const ISF_WORDS = ['TIME', 'TIMEDELTA', 'RENDERSIZE', 'PASSINDEX', 'FRAMEINDEX', 'DATE', 'main'];

export interface Terms {
  readonly credit: string;
  readonly licence: string;
}

interface Picture {
  readonly name: string;
  readonly label: string;
  readonly repeat: boolean;
}

/** Prints the ISF file of a work whose tabs each have a `mainImage`. */
export function printIsf(shader: Shadertoy, terms: Terms): string {
  const tabs = shader.tabs.map((tab) => ({ ...tab, code: withoutChannelDirectives(tab.code) }));
  const words = new Set([shader.common, ...tabs.map(({ code }) => code)].flatMap((code) => [...wordsOf(code)]));
  const taken = new Set([...words, ...ISF_WORDS]);
  const buffers = new Map<BufferLetter, string>();
  for (const { buffer } of tabs) if (buffer !== null) buffers.set(buffer, fresh(`buffer${buffer}`, taken));
  const pictures = channelImagesOf({ tabs, common: shader.common }, buffers, taken);
  const mouse = words.has('iMouse') ? fresh('mouse', taken) : null;
  const { common, codes, macros } = separateTabs({ tabs, common: shader.common });
  const mains = tabs.map((tab) => fresh(`main${tabName(tab).replace(' ', '')}`, taken));
  const sections = tabs.map((tab, i) =>
    section(tab, {
      code: codes[i] ?? '',
      macros: macros[i] ?? [],
      main: mains[i] ?? '',
      alone: tabs.length === 1,
      words,
      buffers,
      pictures,
    }),
  );
  const variables = Object.entries(VARIABLES).filter(([name]) => words.has(name));
  const defines = variables.map(([name, value]) => `#define ${name} ${value.replaceAll('MOUSE', mouse ?? '')}`);
  const parts = [
    header(shader, terms, { pictures: [...pictures.values()], mouse, passes: passesOf(tabs, buffers) }),
    ...(defines.length > 0 ? [`// What Shadertoy calls ISF's variables.\n${defines.join('\n')}`] : []),
    ...(common.trim() === '' ? [] : [`// ---- Common ----\n${common.trim()}`]),
    ...sections,
    mainFunction(mains),
  ];
  return `${parts.join('\n\n')}\n`;
}

/**
 * The layers that replace the images of the tabs, by the key of the image (`Channel`); unused images have none. The first layer is
 * `inputImage`, the node's main input.
 */
function channelImagesOf(
  { tabs, common }: Pick<Shadertoy, 'tabs' | 'common'>,
  buffers: ReadonlyMap<BufferLetter, string>,
  taken: Set<string>,
): Map<string, Picture> {
  const keys = new Map<string, Channel & { kind: 'picture' }>();
  const shared = wordsOf(common);
  for (const { code, channels } of tabs) {
    const words = wordsOf(code);
    channels.forEach((channel, index) => {
      const used = words.has(`iChannel${index}`) || shared.has(`iChannel${index}`) || (tabs.length === 1 && isMeasured(code, index));
      const picture = asImage(channel, buffers);
      if (used && picture && !keys.has(picture.key)) keys.set(picture.key, picture);
    });
  }
  return new Map(
    [...keys.values()].map(({ key, repeat }, i) => {
      const name = fresh(i === 0 ? 'inputImage' : `image${i + 1}`, taken);
      return [key, { name, label: i === 0 ? 'Layer' : `Layer ${i + 1}`, repeat }];
    }),
  );
}

/** Whether the code reads the size of a channel (`iChannelResolution`). An index that is not a literal may refer to any channel. */
function isMeasured(code: string, channel: number): boolean {
  const asked = [...code.matchAll(/\biChannelResolution\s*\[\s*([^\]]*?)\s*\]/g)].map(([, index]) => index ?? '');
  return asked.some((index) => !/^\d+$/.test(index) || Number(index) === channel);
}

/** The image of a channel; null for a buffer. A buffer that the work does not contain is read as an image. */
function asImage(channel: Channel, buffers: ReadonlyMap<BufferLetter, string>): (Channel & { kind: 'picture' }) | null {
  if (channel.kind === 'picture') return channel;
  return buffers.has(channel.buffer) ? null : { kind: 'picture', key: `Buffer ${channel.buffer}`, repeat: false };
}

interface SectionContext {
  readonly code: string;
  readonly macros: readonly string[];
  readonly main: string;
  readonly alone: boolean;
  readonly words: ReadonlySet<string>;
  readonly buffers: ReadonlyMap<BufferLetter, string>;
  readonly pictures: ReadonlyMap<string, Picture>;
}

/** Prints a tab, with defines for its own names. */
function section(tab: Tab, { code, macros, main, alone, words, buffers, pictures }: SectionContext): string {
  const images = tab.channels.map((channel) => {
    const picture = asImage(channel, buffers);
    return picture ? pictures.get(picture.key)?.name : channel.kind === 'buffer' ? buffers.get(channel.buffer) : undefined;
  });
  const own: [string, string][] = [];
  for (let i = 0; i < CHANNEL_COUNT; i++) {
    const image = images[i];
    if (image !== undefined && words.has(`iChannel${i}`)) own.push([`iChannel${i}`, image]);
  }
  if (words.has('iChannelResolution')) {
    const sizes = images.map((image) => (image === undefined ? 'vec3(0.0)' : `vec3(IMG_SIZE(${image}), 1.0)`));
    own.push(['iChannelResolution', `vec3[4](${sizes.join(', ')})`]);
  }
  own.push(['mainImage', main]);
  const undefine = alone ? [] : [...own.map(([name]) => name), ...macros].map((name) => `#undef ${name}`);
  return [`// ---- ${tabName(tab)} ----`, ...own.map(([name, value]) => `#define ${name} ${value}`), code.trim(), ...undefine].join('\n');
}

interface PassText {
  readonly TARGET?: string;
  readonly PERSISTENT?: true;
  readonly FLOAT?: true;
}

/** The entries of `PASSES`. A buffer is persistent if its own pass or an earlier one reads it: that read gets the previous frame. */
function passesOf(tabs: readonly Tab[], buffers: ReadonlyMap<BufferLetter, string>): PassText[] {
  return tabs.map(({ buffer }, place) => {
    const target = buffer === null ? undefined : buffers.get(buffer);
    if (target === undefined) return {};
    const early = tabs.slice(0, place + 1).some(({ channels }) => channels.some((c) => c.kind === 'buffer' && c.buffer === buffer));
    return { TARGET: target, ...(early ? { PERSISTENT: true as const } : {}), FLOAT: true };
  });
}

interface HeaderContext {
  readonly pictures: readonly Picture[];
  readonly mouse: string | null;
  readonly passes: readonly PassText[];
}

function header({ title, description, tags }: Shadertoy, { credit, licence }: Terms, { pictures, mouse, passes }: HeaderContext): string {
  const inputs = [
    ...pictures.map(({ name, label, repeat }) => ({ NAME: name, TYPE: 'image', LABEL: label, ...(repeat ? { WRAP: 'repeat' } : {}) })),
    ...(mouse === null
      ? []
      : [
          {
            NAME: mouse,
            TYPE: 'point2D',
            LABEL: 'Pointer',
            DOC: 'Where the pointer is pressed, from (0, 0) at the bottom left to (1, 1).',
            DEFAULT: [0, 0],
            MIN: [0, 0],
            MAX: [1, 1],
          },
        ]),
  ];
  const lines = [
    `"ISFVSN": "2"`,
    ...(title === '' ? [] : [`"SCRIM_TITLE": ${json(title)}`]),
    `"DESCRIPTION": ${json(description || `${title || 'A shader'}, from shadertoy.com.`)}`,
    `"CREDIT": ${json(credit)}`,
    `"LICENSE": ${json(licence)}`,
    `"CATEGORIES": ${json(['Shadertoy', ...tags])}`,
    block('INPUTS', inputs),
    ...(passes.length > 1 ? [block('PASSES', passes)] : []),
  ];
  return `/*{\n${lines.map((line) => `  ${line}`).join(',\n')}\n}*/`;
}

function block(key: string, entries: readonly unknown[]): string {
  return entries.length === 0 ? `"${key}": []` : `"${key}": [\n${entries.map((entry) => `    ${json(entry)}`).join(',\n')}\n  ]`;
}

/** Prints JSON in which no text ends the surrounding comment. */
function json(value: unknown): string {
  return JSON.stringify(value).replaceAll('*/', '*\\/');
}

/**
 * Prints `main`, which calls the function of the tab whose pass is drawn. The image is opaque, as on the site; buffers keep the alpha that
 * their tab writes.
 */
function mainFunction(mains: readonly string[]): string {
  const calls = mains.map((main, i) => {
    const last = i === mains.length - 1;
    const draw = last ? `{\n    ${main}(color, gl_FragCoord.xy);\n    color.a = 1.0;\n  }` : `${main}(color, gl_FragCoord.xy);`;
    return last && i === 0 ? '' : last ? `else ${draw}` : `${i === 0 ? '' : 'else '}if (PASSINDEX == ${i}) ${draw}`;
  });
  const body = mains.length === 1 ? `${mains[0]}(color, gl_FragCoord.xy);\n  color.a = 1.0;` : calls.join('\n  ');
  return `void main() {\n  vec4 color = vec4(0.0, 0.0, 0.0, 1.0);\n  ${body}\n  gl_FragColor = color;\n}`;
}
