import { Effect, EffectComposer, EffectPass, TextureEffect } from 'postprocessing';
import { Camera, LinearSRGBColorSpace, NearestFilter, NoColorSpace, type Texture, TextureLoader, WebGLRenderer } from 'three';
import { EffectComposer as ThreeComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { ShaderPass } from 'three/addons/postprocessing/ShaderPass.js';
import { TexturePass } from 'three/addons/postprocessing/TexturePass.js';
import { linkProgram } from '../../../nodes/kit/link-program.ts';
import { type Drawn, drawnPixel, measureFrames } from './frame-ms.ts';
import { FULL_SCREEN } from './full-screen.ts';

/** Draws the same effects over the same image as a page without Scrim would. */
export type Contender = 'by hand' | 'by hand, any alpha' | 'postprocessing' | 'EffectComposer';

/**
 * Opens a contender.
 *
 * @param effects GLSL functions `vec3 effectN(vec3 color)` of straight colors.
 */
export async function open(
  contender: Contender,
  imageUrl: string,
  widthPx: number,
  heightPx: number,
  effects: readonly string[],
): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.width = widthPx;
  canvas.height = heightPx;
  document.body.append(canvas);
  stage = await CONTENDERS[contender](canvas, imageUrl, effects);
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage, count);
}

/** The color of a pixel after a frame, to see that all contenders draw the same. Origin bottom left. */
export function pixelAt(x: number, y: number): number[] {
  if (!stage) throw new Error('Nothing is open.');
  return drawnPixel(stage, x, y);
}

let stage: Drawn | null = null;

const CONTENDERS: Readonly<Record<Contender, (canvas: HTMLCanvasElement, imageUrl: string, effects: readonly string[]) => Promise<Drawn>>> =
  {
    'by hand': (...page) => byHand(...page, OPAQUE),
    'by hand, any alpha': (...page) => byHand(...page, ANY_ALPHA),
    postprocessing: withPostprocessing,
    EffectComposer: withEffectComposer,
  };

/** The statement of a shader by hand that applies an effect to a color `c`. */
type Step = (effect: string) => string;

/** For images without transparency. */
const OPAQUE: Step = (effect) => `c.rgb = rounded(clamp(${effect}(c.rgb), 0.0, 1.0));`;

/** For all images: effects get colors that are not multiplied by alpha. */
const ANY_ALPHA: Step = (effect) =>
  `c.rgb = rounded(clamp(${effect}(c.a > 0.0 ? c.rgb / c.a : vec3(0.0)), 0.0, 1.0) * c.a); c.a = rounded(vec3(c.a)).r;`;

/** One shader, which rounds to 8 bits after each effect, as Scrim does. */
async function byHand(canvas: HTMLCanvasElement, imageUrl: string, effects: readonly string[], step: Step): Promise<Drawn> {
  const gl = canvas.getContext('webgl2', { antialias: false, alpha: true });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const image = new Image();
  image.src = imageUrl;
  await image.decode();
  const fragment = `#version 300 es
precision highp float;
in vec2 at;
out vec4 color;
uniform sampler2D image;
${effects.join('\n')}
vec3 rounded(vec3 c) { return roundEven(c * 255.0) / 255.0; }
void main() {
  vec4 c = texture(image, at);
  ${effects.map((_, i) => step(`effect${i}`)).join('\n  ')}
  color = c;
}`;
  const program = linkProgram(gl, FULL_SCREEN, fragment);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? 'The shader cannot be linked.');
  gl.useProgram(program);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  return { gl, draw: () => gl.drawArrays(gl.TRIANGLES, 0, 3) };
}

function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true });
  renderer.setSize(canvas.width, canvas.height, false);
  // The effects change the stored colors, as those of Scrim do.
  renderer.outputColorSpace = LinearSRGBColorSpace;
  return renderer;
}

async function loadTexture(imageUrl: string): Promise<Texture> {
  const texture = await new TextureLoader().loadAsync(imageUrl);
  texture.colorSpace = NoColorSpace;
  texture.generateMipmaps = false;
  texture.minFilter = NearestFilter;
  return texture;
}

/** All effects in one pass of the library pmndrs/postprocessing. */
async function withPostprocessing(canvas: HTMLCanvasElement, imageUrl: string, effects: readonly string[]): Promise<Drawn> {
  const renderer = rendererOn(canvas);
  const texture = await loadTexture(imageUrl);
  const composer = new EffectComposer(renderer);
  const made = effects.map(
    (text, i) =>
      new Effect(
        `Effect${i}`,
        `${text}\nvoid mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) { outputColor = vec4(effect${i}(inputColor.rgb), inputColor.a); }`,
      ),
  );
  composer.addPass(new EffectPass(new Camera(), new TextureEffect({ texture }), ...made));
  return { gl: renderer.getContext(), draw: (deltaS) => composer.render(deltaS) };
}

/** One pass per effect of the EffectComposer of three.js. */
async function withEffectComposer(canvas: HTMLCanvasElement, imageUrl: string, effects: readonly string[]): Promise<Drawn> {
  const renderer = rendererOn(canvas);
  const texture = await loadTexture(imageUrl);
  const composer = new ThreeComposer(renderer);
  composer.addPass(new TexturePass(texture));
  effects.forEach((text, i) => {
    composer.addPass(
      new ShaderPass({
        uniforms: { tDiffuse: { value: null } },
        vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
        fragmentShader: `uniform sampler2D tDiffuse; varying vec2 at;
${text}
void main() { vec4 c = texture2D(tDiffuse, at); gl_FragColor = vec4(effect${i}(c.rgb), c.a); }`,
      }),
    );
  });
  return { gl: renderer.getContext(), draw: (deltaS) => composer.render(deltaS) };
}
