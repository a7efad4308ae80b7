import { type Accessor, Document, type Material, type Mesh, type Node, NodeIO } from '@gltf-transform/core';
import { type BufferGeometry, CapsuleGeometry, CylinderGeometry, SphereGeometry, TorusGeometry } from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import { mergeVertices } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

type Vector = readonly [number, number, number];

/** Duration of the walk cycle in seconds. */
const CYCLE_S = 2;
/** Keyframes per cycle, enough that linear interpolation is not visible. */
const KEYS = 16;

/**
 * A tin wind-up robot, 0.42 m tall, standing at the origin and facing +z, with one clip `walk` that treads in place. Made of
 * rounded primitives, so that it has soft highlights, thin parts (antenna, key) for edge filters, and a clear silhouette.
 */
export async function makeRobot(): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const paint = materials(doc);
  const part = (geometry: BufferGeometry, material: Material, at: Vector = [0, 0, 0], turn: Vector = [0, 0, 0]): Part => ({
    geometry: geometry
      .rotateX(turn[0])
      .rotateY(turn[1])
      .rotateZ(turn[2])
      .translate(...at),
    material,
  });
  const leg = (): Part[] => [
    part(new CapsuleGeometry(0.022, 0.07, 4, 12), paint.steel, [0, -0.05, 0]),
    part(new RoundedBoxGeometry(0.075, 0.035, 0.11, 3, 0.014), paint.dark, [0, -0.1125, 0.014]),
  ];
  const arm = (): Part[] => [
    part(new SphereGeometry(0.026, 20, 14), paint.steel),
    part(new CapsuleGeometry(0.017, 0.075, 4, 12), paint.red, [0, -0.06, 0]),
    part(new TorusGeometry(0.02, 0.008, 10, 20, Math.PI * 1.5), paint.steel, [0, -0.13, 0], [0, Math.PI / 2, 0]),
  ];
  const torso = node(
    doc,
    'torso',
    [0, 0.215, 0],
    [
      part(new RoundedBoxGeometry(0.17, 0.17, 0.11, 3, 0.024), paint.red),
      part(new RoundedBoxGeometry(0.115, 0.075, 0.012, 2, 0.006), paint.cream, [0, 0.02, 0.056]),
      part(new CylinderGeometry(0.014, 0.014, 0.01, 20), paint.lamp, [-0.03, 0.02, 0.064], [Math.PI / 2, 0, 0]),
      part(new CylinderGeometry(0.014, 0.014, 0.01, 20), paint.steel, [0.03, 0.02, 0.064], [Math.PI / 2, 0, 0]),
      part(new RoundedBoxGeometry(0.1, 0.012, 0.012, 2, 0.005), paint.steel, [0, -0.05, 0.056]),
    ],
  );
  const head = node(
    doc,
    'head',
    [0, 0.118, 0],
    [
      part(new CylinderGeometry(0.022, 0.028, 0.03, 20), paint.steel, [0, -0.018, 0]),
      part(new RoundedBoxGeometry(0.12, 0.09, 0.1, 3, 0.022), paint.steel, [0, 0.04, 0]),
      part(new SphereGeometry(0.017, 20, 14), paint.eye, [-0.028, 0.05, 0.048]),
      part(new SphereGeometry(0.017, 20, 14), paint.eye, [0.028, 0.05, 0.048]),
      part(new RoundedBoxGeometry(0.06, 0.01, 0.012, 2, 0.004), paint.dark, [0, 0.014, 0.05]),
      part(new CylinderGeometry(0.003, 0.003, 0.055, 10), paint.steel, [0, 0.11, 0]),
      part(new SphereGeometry(0.011, 16, 12), paint.lamp, [0, 0.142, 0]),
    ],
  );
  const key = node(
    doc,
    'key',
    [0, 0, -0.06],
    [
      part(new CylinderGeometry(0.005, 0.005, 0.04, 12), paint.brass, [0, 0, -0.015], [Math.PI / 2, 0, 0]),
      part(new TorusGeometry(0.017, 0.005, 10, 20), paint.brass, [-0.019, 0, -0.04]),
      part(new TorusGeometry(0.017, 0.005, 10, 20), paint.brass, [0.019, 0, -0.04]),
    ],
  );
  const legs = [node(doc, 'leg.left', [0.042, 0.13, 0], leg()), node(doc, 'leg.right', [-0.042, 0.13, 0], leg())];
  const arms = [node(doc, 'arm.left', [0.108, 0.05, 0], arm()), node(doc, 'arm.right', [-0.108, 0.05, 0], arm())];
  torso.addChild(head).addChild(key);
  for (const limb of arms) torso.addChild(limb);
  const root = doc.createNode('robot').addChild(torso);
  for (const limb of legs) root.addChild(limb);
  doc.createScene('scene').addChild(root);
  animate(doc, { torso, head, key, legs, arms });
  return new NodeIO().writeBinary(doc);
}

interface Part {
  readonly geometry: BufferGeometry;
  readonly material: Material;
}

/** One node whose mesh has a primitive per material, to reduce draw calls. */
function node(doc: Document, name: string, at: Vector, parts: readonly Part[]): Node {
  const mesh = doc.createMesh(name);
  for (const material of new Set(parts.map((p) => p.material))) {
    addPrimitive(
      doc,
      mesh,
      material,
      parts.filter((p) => p.material === material).map((p) => p.geometry),
    );
  }
  return doc
    .createNode(name)
    .setTranslation([...at])
    .setMesh(mesh);
}

function addPrimitive(doc: Document, mesh: Mesh, material: Material, geometries: readonly BufferGeometry[]): void {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (const raw of geometries) {
    // There are no textures, and rounded boxes have separate vertices for each triangle.
    const geometry = mergeVertices(raw.deleteAttribute('uv'));
    const first = positions.length / 3;
    const { position, normal } = geometry.attributes;
    if (!position || !normal) throw new Error('A part has no positions or no normals.');
    positions.push(...position.array);
    normals.push(...normal.array);
    const index = geometry.index ? [...geometry.index.array] : [...Array(position.count).keys()];
    indices.push(...index.map((i) => i + first));
  }
  const accessor = (type: 'VEC3' | 'SCALAR', array: Float32Array | Uint16Array): Accessor =>
    doc.createAccessor().setType(type).setArray(array);
  mesh.addPrimitive(
    doc
      .createPrimitive()
      .setMaterial(material)
      .setAttribute('POSITION', accessor('VEC3', new Float32Array(positions)))
      .setAttribute('NORMAL', accessor('VEC3', new Float32Array(normals)))
      .setIndices(accessor('SCALAR', new Uint16Array(indices))),
  );
}

function materials(doc: Document) {
  const material = (name: string, color: Vector, metallic: number, roughness: number, glow: Vector = [0, 0, 0]): Material =>
    doc
      .createMaterial(name)
      .setBaseColorFactor([...color, 1])
      .setMetallicFactor(metallic)
      .setRoughnessFactor(roughness)
      .setEmissiveFactor([...glow]);
  return {
    red: material('red enamel', [0.62, 0.05, 0.035], 0.1, 0.32),
    cream: material('cream enamel', [0.8, 0.71, 0.52], 0, 0.45),
    steel: material('steel', [0.52, 0.55, 0.58], 0.75, 0.36),
    brass: material('brass', [0.75, 0.5, 0.16], 0.85, 0.3),
    dark: material('rubber', [0.035, 0.037, 0.042], 0, 0.7),
    eye: material('eye', [0.9, 0.87, 0.75], 0, 0.2, [0.45, 0.4, 0.25]),
    lamp: material('lamp', [0.95, 0.45, 0.05], 0, 0.25, [0.9, 0.32, 0.02]),
  };
}

interface Limbs {
  readonly torso: Node;
  readonly head: Node;
  readonly key: Node;
  readonly legs: readonly Node[];
  readonly arms: readonly Node[];
}

/** A walk in place: legs and arms swing, the body sways and bobs twice per step, the key rotates. */
function animate(doc: Document, limbs: Limbs): void {
  const times = Float32Array.from({ length: KEYS + 1 }, (_, i) => (i / KEYS) * CYCLE_S);
  const input = doc.createAccessor('times').setType('SCALAR').setArray(times);
  const clip = doc.createAnimation('walk');
  const add = (target: Node, path: 'rotation' | 'translation', at: (phase: number) => readonly number[]): void => {
    const values = [...times].flatMap((t) => [...at((t / CYCLE_S) * 2 * Math.PI)]);
    const output = doc
      .createAccessor()
      .setType(path === 'rotation' ? 'VEC4' : 'VEC3')
      .setArray(new Float32Array(values));
    const sampler = doc.createAnimationSampler().setInput(input).setOutput(output).setInterpolation('LINEAR');
    clip.addSampler(sampler).addChannel(doc.createAnimationChannel().setTargetNode(target).setTargetPath(path).setSampler(sampler));
  };
  const about = (axis: 0 | 1 | 2, angleRad: number): number[] => {
    const q = [0, 0, 0, Math.cos(angleRad / 2)];
    q[axis] = Math.sin(angleRad / 2);
    return q;
  };
  const [x, y, z] = limbs.torso.getTranslation();
  add(limbs.torso, 'translation', (p) => [x, y + 0.006 * Math.cos(2 * p), z]);
  add(limbs.torso, 'rotation', (p) => about(2, 0.07 * Math.sin(p)));
  add(limbs.head, 'rotation', (p) => about(1, 0.35 * Math.sin(p)));
  // Two rotations per cycle: a quaternion rotated by 4π is unchanged, so the clip loops.
  add(limbs.key, 'rotation', (p) => about(2, 2 * p));
  for (const [i, side] of [1, -1].entries()) {
    const leg = limbs.legs[i];
    const arm = limbs.arms[i];
    if (leg) add(leg, 'rotation', (p) => about(0, side * 0.4 * Math.sin(p)));
    if (arm) add(arm, 'rotation', (p) => about(0, -side * 0.6 * Math.sin(p) - 0.15));
  }
}
