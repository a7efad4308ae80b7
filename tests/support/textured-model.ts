import { Document, NodeIO } from '@gltf-transform/core';
import { encode } from 'fast-png';
import { SphereGeometry } from 'three';

/**
 * A sphere of 1 m with a checkered texture of `sizePx` and a morph target that flattens it. Node `ball` is below `stand`, which the
 * clip `turn` rotates. Node `handle` has no mesh.
 */
export async function texturedModel(sizePx: number): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const geometry = new SphereGeometry(0.5, 96, 64);
  const list = (name: string) => Float32Array.from(geometry.getAttribute(name).array);
  const flat = list('position').map((value, i) => (i % 3 === 1 ? -0.6 * value : 0));
  const accessor = (type: 'VEC2' | 'VEC3' | 'VEC4' | 'SCALAR', array: Float32Array | Uint32Array) =>
    doc.createAccessor().setType(type).setArray(array);
  const picture = doc.createTexture('checks').setImage(checks(sizePx)).setMimeType('image/png');
  const material = doc.createMaterial('paint').setBaseColorTexture(picture).setRoughnessFactor(0.4).setMetallicFactor(0);
  const primitive = doc
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', list('position')))
    .setAttribute('NORMAL', accessor('VEC3', list('normal')))
    .setAttribute('TEXCOORD_0', accessor('VEC2', list('uv')))
    .setIndices(accessor('SCALAR', Uint32Array.from(geometry.index?.array ?? [])))
    .addTarget(doc.createPrimitiveTarget('flat').setAttribute('POSITION', accessor('VEC3', flat)))
    .setMaterial(material);
  const mesh = doc.createMesh('ball').addPrimitive(primitive).setWeights([0.25]);
  const ball = doc.createNode('ball').setMesh(mesh);
  const stand = doc
    .createNode('stand')
    .addChild(ball)
    .addChild(doc.createNode('handle').setTranslation([0, 1, 0]));
  doc.createScene().addChild(stand);
  const sampler = doc
    .createAnimationSampler()
    .setInput(accessor('SCALAR', new Float32Array([0, 1])))
    .setOutput(accessor('VEC4', new Float32Array([0, 0, 0, 1, 0, 1, 0, 0])));
  const channel = doc.createAnimationChannel().setTargetNode(stand).setTargetPath('rotation').setSampler(sampler);
  doc.createAnimation('turn').addSampler(sampler).addChannel(channel);
  return new NodeIO().writeBinary(doc);
}

function checks(sizePx: number): Uint8Array {
  const data = new Uint8Array(sizePx * sizePx * 4);
  for (let y = 0; y < sizePx; y++) {
    for (let x = 0; x < sizePx; x++) {
      const dark = (Math.floor((x * 16) / sizePx) + Math.floor((y * 8) / sizePx)) % 2;
      const shade = Math.round((x * 160) / sizePx);
      // Noise, without which the texture would compress too well.
      const grain = (x * 7919 + y * 104_729) % 13;
      data.set([dark ? 40 + grain : 60 + shade, 90 + grain, dark ? 200 - shade : 50 + grain, 255], (y * sizePx + x) * 4);
    }
  }
  return encode({ width: sizePx, height: sizePx, data, channels: 4 });
}
