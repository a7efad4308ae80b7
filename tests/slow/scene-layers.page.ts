import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  DataTexture,
  FloatType,
  Mesh,
  NearestFilter,
  NeutralToneMapping,
  OrthographicCamera,
  PlaneGeometry,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  SRGBColorSpace,
  type ToneMapping,
  WebGLRenderer,
} from 'three';
import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand } from '../browser/runtime-kit.ts';
import { createGl, createStand, drawView, item, lookingAt, objects, readPixels, translation, viewOf } from '../browser/scenes-kit.ts';

const SIDE = 64;

/** RGBA bytes of a program, bottom row first, and what the player reported. */
export interface Shot {
  readonly pixels: number[];
  readonly told: string[];
}

/** Draws programs with one view. `asset` is the file of all their assets. Without floats, the GPU cannot draw to 16-bit floats. */
export async function shoot(programs: readonly Program[], asset: number[], withoutFloats: boolean): Promise<Shot[]> {
  const load = async (): Promise<ArrayBuffer> => Uint8Array.from(asset).buffer;
  const shots: Shot[] = [];
  for (const program of programs) {
    const gl = createGl(SIDE, SIDE);
    if (withoutFloats) {
      const all = gl.getExtension.bind(gl) as (name: string) => unknown;
      gl.getExtension = ((name: string) => (name.startsWith('EXT_color_buffer') ? null : all(name))) as typeof gl.getExtension;
    }
    const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes, assets: { load } });
    const view = viewOf(lookingAt([0, 0, 2], [0, 0, 0], 1), { x: 0, y: 0, widthPx: SIDE, heightPx: SIDE });
    const sized = { framebufferWidthPx: SIDE, framebufferHeightPx: SIDE };
    player.draw(frame(0, [view], sized));
    await player.settle();
    for (const index of [1, 2]) player.draw(frame(index, [view], sized));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const pixels = [...readPixels(gl, SIDE, SIDE)];
    shots.push({ pixels, told: diagnostics().map(({ code }) => code) });
    if (gl.getError() !== 0) throw new Error('GL has an error.');
    player.dispose();
  }
  return shots;
}

/** Numbers in a scene layer whose objects have colors that are none, and the colors of two of its pixels. */
export function strayNumbers(): { readonly notFinite: number; readonly largest: number; readonly pixels: number[][] } {
  const { gl, backend } = createStand(SIDE, SIDE);
  gl.getExtension('EXT_color_buffer_float');
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, SIDE, SIDE);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const sheets = ['vec4( zero / zero, 1.0 / zero, 2.0, 1.0 )', 'vec4( 0.5, -1.0 / zero, 1e30, zero / zero )'].map((color, i) => {
    const material = new ShaderMaterial({
      uniforms: { zero: { value: 0 } },
      vertexShader: 'void main() {\n gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );\n}',
      fragmentShader: `uniform float zero;\nvoid main() {\n gl_FragColor = ${color};\n}`,
    });
    return item(new Mesh(new PlaneGeometry(1, 9), material), { at: translation(i === 0 ? -0.5 : 0.5, 0, 0) });
  });
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', encoding: 'scene' });
  scene.update([objects(...sheets)], []);
  const view = viewOf(lookingAt([0, 0, 2], [0, 0, 0], 1), { x: 0, y: 0, widthPx: SIDE, heightPx: SIDE });
  scene.draw(drawView(view, framebuffer));
  const pixels = new Float32Array(SIDE * SIDE * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.FLOAT, pixels);
  return {
    notFinite: pixels.filter((value) => !Number.isFinite(value)).length,
    largest: pixels.reduce((most, value) => Math.max(most, value), 0),
    pixels: [16, 48].map((x) => [...pixels.subarray((32 * SIDE + x) * 4, (32 * SIDE + x) * 4 + 4)]),
  };
}

const MAPPINGS: readonly ToneMapping[] = [AgXToneMapping, NeutralToneMapping, ACESFilmicToneMapping];

/** Colors through the tone mappings of three.js, in the order of the choices of Tone map: RGBA bytes. */
export function threesToneMapping(colors: readonly number[], widthPx: number, heightPx: number): number[][] {
  const gl = createGl(widthPx, heightPx);
  const three = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  three.outputColorSpace = SRGBColorSpace;
  // As a scene layer stores them.
  const halves = colors.map((value) => (Math as unknown as { f16round(x: number): number }).f16round(value));
  const map = new DataTexture(Float32Array.from(halves), widthPx, heightPx, RGBAFormat, FloatType);
  map.minFilter = NearestFilter;
  map.magFilter = NearestFilter;
  map.needsUpdate = true;
  const material = new ShaderMaterial({
    uniforms: { map: { value: map } },
    vertexShader: 'varying vec2 vUv; void main() { vUv = uv; gl_Position = vec4( position.xy, 0.0, 1.0 ); }',
    fragmentShader:
      'uniform sampler2D map; varying vec2 vUv; void main() { gl_FragColor = vec4( texture2D( map, vUv ).rgb, 1.0 );\n#include <tonemapping_fragment>\n#include <colorspace_fragment>\n}',
  });
  const scene = new Scene().add(new Mesh(new PlaneGeometry(2, 2), material));
  return MAPPINGS.map((mapping) => {
    three.toneMapping = mapping;
    material.needsUpdate = true;
    three.render(scene, new OrthographicCamera());
    return [...readPixels(gl, widthPx, heightPx)];
  });
}
