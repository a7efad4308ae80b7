import { Document, type Material, NodeIO } from '@gltf-transform/core';
import type { BufferGeometry } from 'three';
import { mergeVertices } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

export interface Paint {
  readonly name: string;
  /** Base color in linear RGB. */
  readonly color: readonly [r: number, g: number, b: number];
  readonly metalness?: number;
  readonly roughness: number;
  /** Light that the surface emits, in linear RGB. */
  readonly glow?: readonly [r: number, g: number, b: number];
  /** A PNG texture by which the color is multiplied. */
  readonly texture?: Uint8Array;
}

/** A part of a model. It becomes a node of its own, because physics makes one convex hull per node. */
export interface ModelPart {
  readonly name: string;
  readonly geometry: BufferGeometry;
  readonly paint: Paint;
}

/** Writes parts as a binary glTF file. */
export async function writeModel(parts: readonly ModelPart[]): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const scene = doc.createScene('scene');
  const materials = new Map<Paint, Material>();
  for (const { name, geometry, paint } of parts) {
    const material = materials.get(paint) ?? createMaterial(doc, paint);
    materials.set(paint, material);
    if (!paint.texture) geometry.deleteAttribute('uv');
    const merged = mergeVertices(geometry);
    const accessor = (type: 'VEC3' | 'VEC2' | 'SCALAR', array: Float32Array | Uint16Array) =>
      doc.createAccessor().setType(type).setArray(array);
    const attribute = (key: string) => new Float32Array(merged.getAttribute(key).array);
    const primitive = doc
      .createPrimitive()
      .setMaterial(material)
      .setAttribute('POSITION', accessor('VEC3', attribute('position')))
      .setAttribute('NORMAL', accessor('VEC3', attribute('normal')))
      .setIndices(accessor('SCALAR', Uint16Array.from(merged.getIndex()?.array ?? [])));
    if (paint.texture) primitive.setAttribute('TEXCOORD_0', accessor('VEC2', attribute('uv')));
    scene.addChild(doc.createNode(name).setMesh(doc.createMesh(name).addPrimitive(primitive)));
  }
  return new NodeIO().writeBinary(doc);
}

function createMaterial(doc: Document, { name, color, metalness = 0, roughness, glow = [0, 0, 0], texture }: Paint): Material {
  const material = doc
    .createMaterial(name)
    .setBaseColorFactor([...color, 1])
    .setMetallicFactor(metalness)
    .setRoughnessFactor(roughness)
    .setEmissiveFactor([...glow]);
  return texture ? material.setBaseColorTexture(doc.createTexture(name).setImage(texture).setMimeType('image/png')) : material;
}
