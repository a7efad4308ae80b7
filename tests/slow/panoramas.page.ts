import {
  Camera,
  HalfFloatType,
  Mesh,
  MeshStandardMaterial,
  NoToneMapping,
  PlaneGeometry,
  PMREMGenerator,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  type Texture,
  type WebGLCubeRenderTarget,
  WebGLRenderTarget,
} from 'three';
import { workAtOnce } from '../../export/runtime/gl/spread-work.ts';
import { loadPanorama } from '../../export/runtime/scenes/environments/load-panorama.ts';
import { prefilter } from '../../export/runtime/scenes/environments/prefilter.ts';
import { readRadiance } from '../../export/runtime/scenes/environments/read-radiance.ts';
import { createSceneRenderer } from '../../export/runtime/scenes/scene-renderer.ts';
import { createGl, HEIGHT, lookingAt, readPixels, WIDTH } from '../browser/scenes-kit.ts';

export interface Compared {
  readonly sizePx: readonly [number, number];
  /** Per roughness: the mean difference of a ball's pixels lit by our filter and by three's, of 255, and their mean brightness. */
  readonly balls: readonly { readonly roughness: number; readonly mean: number; readonly brightness: number }[];
}

/** Balls of several roughnesses under one panorama, lit through our filter and through three's own. */
export async function compare(url: string): Promise<Compared> {
  const gl = createGl();
  const renderer = createSceneRenderer({ gl, canvas: gl.canvas });
  const { three } = renderer;
  three.toneMapping = NoToneMapping;
  const panorama = await loadPanorama(await (await fetch(url)).arrayBuffer(), three.capabilities.maxTextureSize, readRadiance);
  // Ours has the middle of the picture at -z, three's at +x: a quarter turn.
  const ours = workAtOnce(prefilter(renderer, panorama));
  let theirs: WebGLCubeRenderTarget | null = null;
  renderer.work(() => {
    theirs = new PMREMGenerator(three).fromEquirectangular(reduced(three, panorama.texture)) as unknown as WebGLCubeRenderTarget;
  });
  if (theirs === null) throw new Error('three made no filter');
  const theirTexture = (theirs as WebGLCubeRenderTarget).texture;
  // Exposed so that the mean is a middle gray: differences of white and black are none.
  const exposure = 0.2 / (await meanRadiance(three, ours.texture, gl));
  const balls = [0.2, 0.4, 0.7, 1].map((roughness) => {
    const a = shoot(three, gl, ours.texture, roughness, 0, exposure);
    const b = shoot(three, gl, theirTexture, roughness, Math.PI / 2, exposure);
    return { roughness, mean: meanDifference(a, b), brightness: meanOf(a) };
  });
  ours.dispose();
  panorama.dispose();
  return { sizePx: [panorama.widthPx, panorama.heightPx], balls };
}

type Three = ReturnType<typeof createSceneRenderer>['three'];

/** The time of three's filter grows with the pixels of a panorama, and the balls are rougher than the pixels of this one. */
const MOST_WIDTH_PX = 512;

/** A panorama of the mean radiance of squares of pixels. */
function reduced(three: Three, texture: Texture): Texture {
  const { width, height } = texture.image as { readonly width: number; readonly height: number };
  const step = Math.max(1, Math.round(width / MOST_WIDTH_PX));
  if (step === 1) return texture;
  const target = new WebGLRenderTarget(Math.floor(width / step), Math.floor(height / step), { type: HalfFloatType, depthBuffer: false });
  target.texture.mapping = texture.mapping;
  const material = new ShaderMaterial({
    uniforms: { panorama: { value: texture } },
    vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader: `
      uniform highp sampler2D panorama;
      void main() {
        vec3 sum = vec3(0.0);
        ivec2 first = ivec2(gl_FragCoord.xy) * ${step};
        for (int i = 0; i < ${step * step}; i++)
          sum += texelFetch(panorama, first + ivec2(i % ${step}, i / ${step}), 0).rgb;
        gl_FragColor = vec4(sum / ${step * step}.0, 1.0);
      }`,
    depthTest: false,
  });
  const scene = new Scene();
  const plane = new Mesh(new PlaneGeometry(2, 2), material);
  plane.frustumCulled = false;
  scene.add(plane);
  three.setRenderTarget(target);
  three.render(scene, new Camera());
  three.setRenderTarget(null);
  return target.texture;
}

function shoot(
  three: Three,
  gl: WebGL2RenderingContext,
  environment: Texture,
  roughness: number,
  turn: number,
  exposure: number,
): Uint8Array {
  const scene = new Scene();
  scene.add(new Mesh(new SphereGeometry(0.5, 48, 32), new MeshStandardMaterial({ roughness, metalness: 1 })));
  scene.environment = environment;
  scene.environmentRotation.y = turn;
  scene.environmentIntensity = exposure;
  three.setRenderTarget(null);
  three.clear(true, true, true);
  three.render(scene, lookingAt([0, 0, 1.4], [0, 0, 0]));
  return readPixels(gl, WIDTH, HEIGHT);
}

/** Of what a rough ball sends back, undone from sRGB; a first guess is enough. */
async function meanRadiance(three: Three, environment: Texture, gl: WebGL2RenderingContext): Promise<number> {
  for (let exposure = 1; ; exposure *= 0.5) {
    const mean = meanOf(shoot(three, gl, environment, 1, 0, exposure)) / 255;
    if (mean < 0.6) return (mean <= 0.04045 ? mean / 12.92 : ((mean + 0.055) / 1.055) ** 2.4) / exposure;
  }
}

function meanOf(pixels: Uint8Array): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] !== 255) continue;
    sum += (pixels[i] ?? 0) + (pixels[i + 1] ?? 0) + (pixels[i + 2] ?? 0);
    count += 3;
  }
  return sum / count;
}

function meanDifference(a: Uint8Array, b: Uint8Array): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if (a[i + 3] !== 255) continue;
    for (let c = 0; c < 3; c++) sum += Math.abs((a[i + c] ?? 0) - (b[i + c] ?? 0));
    count += 3;
  }
  return sum / count;
}
