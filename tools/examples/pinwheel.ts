import { Document, type Material, type Mesh, NodeIO } from '@gltf-transform/core';
import { BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute } from 'three';

type Vector = readonly [number, number, number];

/** Duration of one rotation in seconds. */
const TURN_S = 2;

/** Corners of the two triangles of one paper sail, in meters. The outer corner is bent forward. */
const SAIL: readonly Vector[] = [
  [0, 0, 0.004],
  [0.11, 0, 0.004],
  [0.09, 0.09, 0.03],
  [0, 0, 0.004],
  [0.09, 0.09, 0.03],
  [0.015, 0.1, 0.01],
];

/** A paper windmill on a stick, 0.4 m tall, at the origin and facing +z. The clip `spin` rotates the wheel once. */
export async function makePinwheel(): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const paint = (name: string, color: Vector): Material =>
    doc
      .createMaterial(name)
      .setBaseColorFactor([...color, 1])
      .setMetallicFactor(0)
      .setRoughnessFactor(0.6)
      .setDoubleSided(true);
  const stick = doc.createMesh('stick');
  const wheel = doc.createMesh('wheel');
  addPrimitive(doc, stick, paint('wood', [0.55, 0.36, 0.18]), new CylinderGeometry(0.006, 0.006, 0.3, 8).translate(0, 0.15, 0));
  const papers: readonly Vector[] = [
    [0.8, 0.08, 0.06],
    [0.95, 0.7, 0.1],
    [0.1, 0.35, 0.75],
    [0.15, 0.55, 0.2],
  ];
  for (const [i, color] of papers.entries()) {
    addPrimitive(doc, wheel, paint(`paper ${i + 1}`, color), sail((i * Math.PI) / 2));
  }
  addPrimitive(doc, wheel, paint('pin', [0.8, 0.8, 0.82]), new BoxGeometry(0.014, 0.014, 0.02).translate(0, 0, 0.01));
  const turning = doc.createNode('wheel').setTranslation([0, 0.29, 0.008]).setMesh(wheel);
  const root = doc.createNode('pinwheel').addChild(doc.createNode('stick').setMesh(stick)).addChild(turning);
  doc.createScene('scene').addChild(root);

  // Quarter rotations about z, so that interpolation takes the right direction.
  const times = Float32Array.from({ length: 5 }, (_, i) => (i / 4) * TURN_S);
  const turns = [...times].flatMap((t) => [0, 0, Math.sin((Math.PI * t) / TURN_S), Math.cos((Math.PI * t) / TURN_S)]);
  const sampler = doc
    .createAnimationSampler()
    .setInput(doc.createAccessor().setType('SCALAR').setArray(times))
    .setOutput(doc.createAccessor().setType('VEC4').setArray(new Float32Array(turns)))
    .setInterpolation('LINEAR');
  const channel = doc.createAnimationChannel().setTargetNode(turning).setTargetPath('rotation').setSampler(sampler);
  doc.createAnimation('spin').addSampler(sampler).addChannel(channel);
  return new NodeIO().writeBinary(doc);
}

function sail(angleRad: number): BufferGeometry {
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(SAIL.flat(), 3)).rotateZ(angleRad);
  geometry.computeVertexNormals();
  return geometry;
}

function addPrimitive(doc: Document, mesh: Mesh, material: Material, geometry: BufferGeometry): void {
  const primitive = doc.createPrimitive().setMaterial(material);
  for (const [semantic, name] of [
    ['POSITION', 'position'],
    ['NORMAL', 'normal'],
  ] as const) {
    const array = Float32Array.from(geometry.getAttribute(name).array);
    primitive.setAttribute(semantic, doc.createAccessor().setType('VEC3').setArray(array));
  }
  if (geometry.index) primitive.setIndices(doc.createAccessor().setType('SCALAR').setArray(Uint16Array.from(geometry.index.array)));
  mesh.addPrimitive(primitive);
}
