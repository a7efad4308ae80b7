import { Document, NodeIO } from '@gltf-transform/core';
import { encode } from 'fast-png';

/**
 * An orange tile, 1 m, that faces +z, as three files: `tile.gltf`, `tile.bin` and `paint on wood.png`.
 *
 * @param scales Animations of 1 s, each of which gives the tile one size: name → scale.
 */
export async function looseModel(
  scales: Readonly<Record<string, number>> = {},
): Promise<Readonly<Record<string, Uint8Array<ArrayBuffer>>>> {
  const doc = new Document();
  doc.createBuffer().setURI('tile.bin');
  const list = (type: 'SCALAR' | 'VEC2' | 'VEC3', ...values: number[]) =>
    doc.createAccessor().setType(type).setArray(new Float32Array(values));
  const color = encode({ width: 1, height: 1, data: new Uint8Array([255, 120, 20, 255]), channels: 4 });
  const paint = doc.createTexture('paint').setURI('paint on wood.png').setImage(color).setMimeType('image/png');
  const primitive = doc
    .createPrimitive()
    .setAttribute('POSITION', list('VEC3', -0.5, 0, 0, 0.5, 0, 0, 0.5, 1, 0, -0.5, 1, 0))
    .setAttribute('NORMAL', list('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1))
    .setAttribute('TEXCOORD_0', list('VEC2', 0, 1, 1, 1, 1, 0, 0, 0))
    .setIndices(
      doc
        .createAccessor()
        .setType('SCALAR')
        .setArray(new Uint16Array([0, 1, 2, 0, 2, 3])),
    )
    .setMaterial(doc.createMaterial('paint').setBaseColorTexture(paint).setMetallicFactor(0).setDoubleSided(true));
  const tile = doc.createNode('tile').setMesh(doc.createMesh('tile').addPrimitive(primitive));
  doc.createScene().addChild(tile);
  for (const [name, scale] of Object.entries(scales)) {
    const sampler = doc
      .createAnimationSampler()
      .setInput(list('SCALAR', 0, 1))
      .setOutput(list('VEC3', ...Array<number>(6).fill(scale)));
    const channel = doc.createAnimationChannel().setTargetNode(tile).setTargetPath('scale').setSampler(sampler);
    doc.createAnimation(name).addSampler(sampler).addChannel(channel);
  }
  const { json, resources } = await new NodeIO().writeJSON(doc, { basename: 'tile' });
  const files: Record<string, Uint8Array<ArrayBuffer>> = { 'tile.gltf': new TextEncoder().encode(JSON.stringify(json)) };
  for (const [uri, bytes] of Object.entries(resources)) files[decodeURIComponent(uri)] = Uint8Array.from(bytes);
  return files;
}
