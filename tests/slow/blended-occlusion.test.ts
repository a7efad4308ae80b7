import { Document, NodeIO } from '@gltf-transform/core';
import { describe, expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry } from 'three';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';

/** As `scenes-kit.ts` draws. */
const WIDTH = 160;

const page = useModule('tests/slow/blended-occlusion.page.ts');

interface Part {
  readonly geometry: BufferGeometry;
  readonly color: readonly [number, number, number, number];
  readonly blended: boolean;
  /** Its picture is opaque in a disc, and empty around it. */
  readonly disc?: true;
}

/** A glTF file whose transparent materials have alpha mode BLEND: loaders give them no depth. */
async function modelOf(...parts: readonly Part[]): Promise<string> {
  const doc = new Document();
  doc.createBuffer();
  const scene = doc.createScene();
  const accessor = (type: 'VEC2' | 'VEC3' | 'SCALAR', array: Float32Array | Uint32Array) =>
    doc.createAccessor().setType(type).setArray(array);
  for (const { geometry, color, blended, disc } of parts) {
    const list = (name: string) => Float32Array.from(geometry.getAttribute(name).array);
    const material = doc
      .createMaterial()
      .setBaseColorFactor([...color])
      .setAlphaMode(blended ? 'BLEND' : 'OPAQUE');
    if (disc) material.setBaseColorTexture(doc.createTexture().setImage(discImage(64)).setMimeType('image/png'));
    const primitive = doc
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', list('position')))
      .setAttribute('NORMAL', accessor('VEC3', list('normal')))
      .setAttribute('TEXCOORD_0', accessor('VEC2', list('uv')))
      .setIndices(accessor('SCALAR', Uint32Array.from(geometry.index?.array ?? [])))
      .setMaterial(material);
    scene.addChild(doc.createNode().setMesh(doc.createMesh().addPrimitive(primitive)));
  }
  return `data:model/gltf-binary;base64,${Buffer.from(await new NodeIO().writeBinary(doc)).toString('base64')}`;
}

function discImage(sizePx: number): Uint8Array<ArrayBuffer> {
  const data = Uint8Array.from({ length: sizePx * sizePx * 4 }, (_, i) => {
    const [x, y] = [((i >> 2) % sizePx) - sizePx / 2, Math.floor((i >> 2) / sizePx) - sizePx / 2];
    return i % 4 === 3 && Math.hypot(x, y) > sizePx / 3 ? 0 : 255;
  });
  return Uint8Array.from(encode({ width: sizePx, height: sizePx, channels: 4, data }));
}

/** `early`: hidden while it is drawn. `layer`: finished, through a filter that changes nothing, and then hidden by its layer's depth. */
function programOf(form: 'early' | 'layer' | 'whole'): Program {
  const last = { early: 'hide', layer: 'hide', whole: 'scene' }[form];
  return compileText(
    projectText({
      nodes: {
        'model-0000': ['source/model', { model: 'model' }],
        'light-0000': 'light/directional',
        'scene-0000': 'layer/scene',
        ...(form === 'layer' && { 'same-0000': ['filter/sepia', { amount: 0 }] }),
        ...(form !== 'whole' && { 'depth-0000': ['world/depth', { filter: 'nearest' }], 'hide-0000': 'layer/depth-occlusion' }),
        'screen-0000': ['output/screen', { antialias: false }],
      },
      wires: [
        'model-0000.objects -> scene-0000.objects',
        'light-0000.lights -> scene-0000.lights',
        ...(form === 'early' ? ['scene-0000.layer -> hide-0000.layer'] : []),
        ...(form === 'layer' ? ['scene-0000.layer -> same-0000.inputImage', 'same-0000.layer -> hide-0000.layer'] : []),
        ...(form !== 'whole' ? ['depth-0000.depth -> hide-0000.depth'] : []),
        `${last}-0000.layer -> screen-0000.layer`,
      ],
      assets: { model: { path: 'model.glb', kind: 'model' } },
    }),
  );
}

const at = (geometry: BufferGeometry, y: number, z = 0): BufferGeometry => geometry.translate(0, y, z);
const GLASS = { color: [0.4, 0.8, 0.9, 0.4], blended: true } as const;
const BALL = { color: [0.9, 0.3, 0.1, 1], blended: false } as const;

/** One above the other, each across the middle of the view. */
const THINGS: readonly Part[] = [
  { ...GLASS, geometry: at(new BoxGeometry(0.5, 0.3, 0.5).rotateY(0.5), 0.6) },
  // With something in it.
  { ...GLASS, geometry: at(new BoxGeometry(0.6, 0.4, 0.5).rotateY(-0.3), 0.15) },
  { ...BALL, geometry: at(new SphereGeometry(0.15), 0.15) },
  { geometry: at(new PlaneGeometry(0.6, 0.4), -0.3), color: [0.3, 0.8, 0.2, 1], blended: true, disc: true },
  // Exporters often say that things blend which are opaque.
  { ...BALL, geometry: at(new SphereGeometry(0.15), -0.65), blended: true },
];

const alphaOf = (picture: readonly number[], half: 'left' | 'right'): number[] =>
  picture.filter((_, i) => i % 4 === 3 && (i >> 2) % WIDTH < WIDTH / 2 === (half === 'left'));

describe('transparent objects behind the room', () => {
  test('are hidden alike while they are drawn and as a finished layer', async () => {
    const programs = [programOf('early'), programOf('layer'), programOf('whole')];
    expect(programs.map(({ presentation }) => presentation.mode)).toEqual(['forward', 'composed', 'forward']);
    const [early = [], layer = [], whole = []] = await page.call<number[][]>('shoot', programs, await modelOf(...THINGS), 1);
    expect(early.filter((value, i) => Math.abs(value - (layer[i] ?? 0)) > 1)).toEqual([]);
    expect(alphaOf(whole, 'left').filter((alpha) => alpha > 90).length).toBeGreaterThan(1000);
    expect(alphaOf(early, 'left').filter((alpha) => alpha > 0)).toEqual([]);
    // All of the half before the room is there.
    expect(alphaOf(early, 'right')).toEqual(alphaOf(whole, 'right'));
  });

  test('an object behind glass and behind the room is hidden, and the glass is not', async () => {
    const model = await modelOf(
      { ...GLASS, geometry: at(new PlaneGeometry(1, 1), 0, 0.9) },
      { ...BALL, geometry: new SphereGeometry(0.3) },
    );
    const [early = [], whole = []] = await page.call<number[][]>('shoot', [programOf('early'), programOf('whole')], model, 1.4);
    const left = (60 * WIDTH + WIDTH / 2 - 12) * 4;
    const right = left + 24 * 4;
    expect([left, right].map((i) => whole[i + 3])).toEqual([255, 255]);
    expect([left, right].map((i) => early[i + 3])).toEqual([102, 255]);
  });
});
