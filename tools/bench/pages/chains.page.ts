import { Effect, EffectAttribute, EffectComposer, EffectPass, TextureEffect } from 'postprocessing';
import {
  Camera,
  ClampToEdgeWrapping,
  DataTexture,
  HalfFloatType,
  LinearFilter,
  LinearSRGBColorSpace,
  NoColorSpace,
  RedFormat,
  type Texture,
  TextureLoader,
  Uniform,
  UnsignedByteType,
  WebGLRenderer,
} from 'three';
import { EffectComposer as ThreeComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { ShaderPass } from 'three/addons/postprocessing/ShaderPass.js';
import { TexturePass } from 'three/addons/postprocessing/TexturePass.js';
import { linkProgram } from '../../../nodes/kit/link-program.ts';
import { ACROSS, BLUR, CURVES, INK, LUMA, SEPIA, VIGNETTE } from './chain-effects.ts';
import { countFrame, type FrameFacts } from './frame-facts.ts';
import { type Drawn, drawnPixels, measureFrames } from './frame-ms.ts';
import { FULL_SCREEN } from './full-screen.ts';

/** `blurred`: sepia, vignette, blur, grayscale, curves. `masked`: ink, but the photo where it is bright; sepia over all. */
export type Chain = 'blurred' | 'masked';
/** Draws a chain as a page without Scrim would. */
export type Contender = 'by hand' | 'postprocessing' | 'EffectComposer';

interface Stage {
  readonly canvas: HTMLCanvasElement;
  readonly imageUrl: string;
}

/** Opens a contender with an opaque image. */
export async function open(chain: Chain, contender: Contender, imageUrl: string, widthPx: number, heightPx: number): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  document.body.append(canvas);
  drawn = await CONTENDERS[contender]({ canvas, imageUrl }, chain);
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export const frameMs = (count: number): number => measureFrames(opened(), count);

/** The colors of pixels after a frame. Origin bottom left. */
export const pixelsAt = (places: readonly (readonly [number, number])[]): number[][] => drawnPixels(opened(), places);

/** Passes and targets of a frame. */
export const facts = (): FrameFacts => countFrame(opened());

let drawn: Drawn | null = null;

function opened(): Drawn {
  if (!drawn) throw new Error('Nothing is open.');
  return drawn;
}

const CONTENDERS: Readonly<Record<Contender, (stage: Stage, chain: Chain) => Promise<Drawn>>> = {
  'by hand': byHand,
  postprocessing: withPostprocessing,
  EffectComposer: withEffectComposer,
};

/** A curve that changes nothing, which is the default of the node. */
const CURVE = Uint8Array.from({ length: 256 }, (_, i) => i);

// --- By hand: as few passes as the images allow, rounded to 8 bits after each effect, as Scrim does.

interface HandPass {
  readonly functions: readonly string[];
  /** The statements that set `color`. */
  readonly body: string;
  readonly reads: readonly ('photo' | 'curve' | 'a' | 'b')[];
  readonly to: 'a' | 'b' | 'screen';
}

const ROUNDED = 'vec3 rounded(vec3 c) { return roundEven(clamp(c, 0.0, 1.0) * 255.0) / 255.0; }';

const HAND_PASSES: Readonly<Record<Chain, readonly HandPass[]>> = {
  blurred: [
    {
      functions: [SEPIA, VIGNETTE],
      body: 'color = vec4(vignette(rounded(sepia(texture(photo, at).rgb)), at), 1.0);',
      reads: ['photo'],
      to: 'a',
    },
    { functions: [BLUR], body: 'color = blurred(a, at, vec2(stepUv.x, 0.0));', reads: ['a'], to: 'b' },
    {
      functions: [BLUR, LUMA, CURVES],
      body: 'color = vec4(graded(curve, rounded(vec3(luma(rounded(blurred(b, at, vec2(0.0, stepUv.y)).rgb))))), 1.0);',
      reads: ['b', 'curve'],
      to: 'screen',
    },
  ],
  masked: [
    { functions: [ACROSS], body: 'color = across(photo, at, stepUv.x);', reads: ['photo'], to: 'a' },
    {
      functions: [INK, LUMA, SEPIA],
      body: `vec3 c = texture(photo, at).rgb;
  vec3 drawn = rounded(vec3(ink(a, at, stepUv.y)));
  float light = step(0.5, luma(c));
  color = vec4(sepia(rounded(mix(drawn, c, light))), 1.0);`,
      reads: ['a', 'photo'],
      to: 'screen',
    },
  ],
};

async function byHand({ canvas, imageUrl }: Stage, chain: Chain): Promise<Drawn> {
  const gl = canvas.getContext('webgl2', { antialias: false, alpha: true });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  gl.getExtension('EXT_color_buffer_float');
  const image = new Image();
  image.src = imageUrl;
  await image.decode();
  const { width, height } = canvas;
  const texture = (fill: () => void): WebGLTexture => {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    for (const [name, value] of [
      [gl.TEXTURE_MIN_FILTER, gl.LINEAR],
      [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
      [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
    ] as const) {
      gl.texParameteri(gl.TEXTURE_2D, name, value);
    }
    fill();
    return made;
  };
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
  const format = chain === 'masked' ? gl.RGBA16F : gl.RGBA8;
  const target = (): WebGLTexture => texture(() => gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height));
  const textures = {
    photo: texture(() => gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image)),
    curve: texture(() => gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 256, 1, 0, gl.RED, gl.UNSIGNED_BYTE, CURVE)),
    a: target(),
    b: target(),
  };
  const passes = HAND_PASSES[chain].map(({ functions, body, reads, to }) => {
    const fragment = `#version 300 es
precision highp float;
in vec2 at;
out vec4 color;
uniform vec2 stepUv;
${reads.map((name) => `uniform sampler2D ${name};`).join('\n')}
${ROUNDED}
${functions.join('\n')}
void main() { ${body} }`;
    const program = linkProgram(gl, FULL_SCREEN, fragment);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? 'The shader cannot be linked.');
    gl.useProgram(program);
    gl.uniform2f(gl.getUniformLocation(program, 'stepUv'), 1 / width, 1 / height);
    for (const [unit, name] of reads.entries()) gl.uniform1i(gl.getUniformLocation(program, name), unit);
    const framebuffer = to === 'screen' ? null : gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    if (to !== 'screen') gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textures[to], 0);
    return { program, framebuffer, reads };
  });
  return {
    gl,
    draw: () => {
      for (const { program, framebuffer, reads } of passes) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.useProgram(program);
        for (const [unit, name] of reads.entries()) {
          gl.activeTexture(gl.TEXTURE0 + unit);
          gl.bindTexture(gl.TEXTURE_2D, textures[name]);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      }
    },
  };
}

// --- With libraries.

interface Prepared {
  readonly renderer: WebGLRenderer;
  readonly photo: Texture;
  readonly curve: Texture;
}

async function prepare({ canvas, imageUrl }: Stage): Promise<Prepared> {
  const renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true });
  renderer.setSize(canvas.width, canvas.height, false);
  // The effects change the stored colors, as those of Scrim do.
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const photo = await new TextureLoader().loadAsync(imageUrl);
  const curve = new DataTexture(CURVE, 256, 1, RedFormat);
  for (const texture of [photo, curve]) {
    Object.assign(texture, { colorSpace: NoColorSpace, generateMipmaps: false, minFilter: LinearFilter, magFilter: LinearFilter });
    Object.assign(texture, { wrapS: ClampToEdgeWrapping, wrapT: ClampToEdgeWrapping });
    texture.needsUpdate = true;
  }
  return { renderer, photo, curve };
}

/** An effect of pmndrs/postprocessing. Effects that read neighbors of a pass before are convolutions, which begin a pass. */
function effect(name: string, functions: readonly string[], color: string, textures: Readonly<Record<string, Texture>>, convolves = false) {
  const samplers = Object.keys(textures).map((sampler) => `uniform sampler2D ${sampler};`);
  const main = `void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) { outputColor = ${color}; }`;
  return new Effect(name, [...samplers, ...functions, main].join('\n'), {
    attributes: convolves ? EffectAttribute.CONVOLUTION : EffectAttribute.NONE,
    uniforms: new Map(Object.entries(textures).map(([sampler, texture]) => [sampler, new Uniform(texture)])),
  });
}

/** As few passes as the library allows. */
async function withPostprocessing(stage: Stage, chain: Chain): Promise<Drawn> {
  const { renderer, photo, curve } = await prepare(stage);
  const composer = new EffectComposer(renderer, {
    depthBuffer: false,
    stencilBuffer: false,
    frameBufferType: chain === 'masked' ? HalfFloatType : UnsignedByteType,
  });
  const passes =
    chain === 'blurred'
      ? [
          [
            new TextureEffect({ texture: photo }),
            effect('Sepia', [SEPIA], 'vec4(sepia(inputColor.rgb), 1.0)', {}),
            effect('Vignette', [VIGNETTE], 'vec4(vignette(inputColor.rgb, uv), 1.0)', {}),
          ],
          [effect('Across', [BLUR], 'blurred(inputBuffer, uv, vec2(texelSize.x, 0.0))', {}, true)],
          [
            effect('Along', [BLUR], 'blurred(inputBuffer, uv, vec2(0.0, texelSize.y))', {}, true),
            effect('Grayscale', [LUMA], 'vec4(vec3(luma(inputColor.rgb)), 1.0)', {}),
            effect('Curves', [CURVES], 'vec4(graded(curve, inputColor.rgb), 1.0)', { curve }),
          ],
        ]
      : [
          [effect('Across', [ACROSS], 'across(photo, uv, texelSize.x)', { photo })],
          [
            effect('Ink', [INK], 'vec4(vec3(ink(inputBuffer, uv, texelSize.y)), 1.0)', {}, true),
            // Effects form a chain, so the mask and the choice are one effect.
            effect('Choose', [LUMA], 'mix(inputColor, texture(photo, uv), step(0.5, luma(texture(photo, uv).rgb)))', { photo }),
            effect('Sepia', [SEPIA], 'vec4(sepia(inputColor.rgb), 1.0)', {}),
          ],
        ];
  for (const effects of passes) composer.addPass(new EffectPass(new Camera(), ...effects));
  return { gl: renderer.getContext(), draw: (deltaS) => composer.render(deltaS) };
}

/** One pass per effect of the EffectComposer of three.js. */
async function withEffectComposer(stage: Stage, chain: Chain): Promise<Drawn> {
  const { renderer, photo, curve } = await prepare(stage);
  const { width, height } = stage.canvas;
  const pass = (functions: readonly string[], color: string, textures: Readonly<Record<string, Texture>> = {}) =>
    new ShaderPass({
      uniforms: Object.fromEntries(['tDiffuse', ...Object.keys(textures)].map((name) => [name, { value: textures[name] ?? null }])),
      vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `varying vec2 at;
${['tDiffuse', ...Object.keys(textures)].map((name) => `uniform sampler2D ${name};`).join('\n')}
const vec2 stepUv = vec2(${1 / width}, ${1 / height});
${functions.join('\n')}
void main() { vec4 c = texture2D(tDiffuse, at); gl_FragColor = ${color}; }`,
    });
  const composer = new ThreeComposer(renderer);
  composer.addPass(new TexturePass(photo));
  if (chain === 'blurred') {
    composer.addPass(pass([SEPIA], 'vec4(sepia(c.rgb), c.a)'));
    composer.addPass(pass([VIGNETTE], 'vec4(vignette(c.rgb, at), c.a)'));
    composer.addPass(pass([BLUR], 'blurred(tDiffuse, at, vec2(stepUv.x, 0.0))'));
    composer.addPass(pass([BLUR], 'blurred(tDiffuse, at, vec2(0.0, stepUv.y))'));
    composer.addPass(pass([LUMA], 'vec4(vec3(luma(c.rgb)), c.a)'));
    composer.addPass(pass([CURVES], 'vec4(graded(curve, c.rgb), c.a)', { curve }));
    return { gl: renderer.getContext(), draw: (deltaS) => composer.render(deltaS) };
  }
  // A composer keeps one image, so the mask needs a composer of its own, as in the example “selective bloom” of three.js.
  const mask = new ThreeComposer(renderer);
  mask.renderToScreen = false;
  mask.addPass(new TexturePass(photo));
  mask.addPass(pass([LUMA], 'vec4(vec3(step(0.5, luma(c.rgb))), c.a)'));
  composer.addPass(pass([ACROSS], 'across(tDiffuse, at, stepUv.x)'));
  composer.addPass(pass([INK], 'vec4(vec3(ink(tDiffuse, at, stepUv.y)), 1.0)'));
  const choose = pass([LUMA], 'vec4(mix(c.rgb, texture2D(photo, at).rgb, luma(texture2D(mask, at).rgb)), 1.0)', {
    photo,
    mask: mask.readBuffer.texture,
  });
  composer.addPass(choose);
  composer.addPass(pass([SEPIA], 'vec4(sepia(c.rgb), c.a)'));
  const { mask: shown } = choose.uniforms as { mask: { value: Texture } };
  return {
    gl: renderer.getContext(),
    draw: (deltaS) => {
      mask.render(deltaS);
      shown.value = mask.readBuffer.texture;
      composer.render(deltaS);
    },
  };
}
