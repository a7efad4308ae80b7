import { BufferAttribute, BufferGeometry, DataTexture, FloatType, type IUniform, type Mesh, RGBAFormat } from 'three';
import { isSkinned, materialsOf } from '../../proxies/drawable.ts';
import { collectEdges, type WeldedTriangles, weldTriangles } from '../../volumes/mesh-shape.ts';
import { isDeformed, restVertices } from '../../volumes/pose-vertices.ts';
import { type EdgeSegment, findSegments } from './mesh-edges.ts';
import { hasBorder, simplify } from './simplify.ts';

/** The edges of a mesh as four vertices per segment, which the vertex shader of `edge-wrapper.ts` places. */
export interface EdgeGeometry {
  /** An index without attributes of its own: `gl_VertexID` gives the segment and the corner. */
  readonly geometry: BufferGeometry;
  /** A number that no other edge geometry has. */
  readonly id: number;
  /** Textures of the vertices and of the segments. */
  readonly uniforms: Readonly<Record<string, IUniform>>;
  /** Whether the mesh has a border. */
  readonly isOpen: boolean;
}

/**
 * Maximum number of segments. Each pass places four vertices per segment and poses four vertices of the mesh for each, so more would cost a
 * phone several milliseconds per pass, and segments would be shorter than a pixel.
 */
const MAX_SEGMENTS = 120_000;

/** A closed mesh has 1.5 edges per triangle; one with more triangles is simplified to `FEWER_TRIANGLES` before its edges are searched. */
const MAX_TRIANGLES = MAX_SEGMENTS / 1.5;
const FEWER_TRIANGLES = 60_000;

/** Stands for an infinite distance between lines: it may be scaled, and shaders need not support infinity. */
const ROOMY = 1e9;

/** Width of the textures; `edge-wrapper.ts` reads it from the textures. */
const WIDTH = 1024;

const known = new WeakMap<BufferGeometry, Map<string, EdgeGeometry | null>>();

/**
 * Returns the edges of a mesh, created at the first call and disposed with the geometry of the mesh. A mesh with too many has those of a
 * simplified mesh (ADR 53).
 *
 * @param isUsed Whether the material with this index takes part.
 * @param ifOpen Whether a mesh without a border gives null, which saves the search.
 */
export function edgeGeometryOf(master: Mesh, isUsed: (materialIndex: number) => boolean, ifOpen: boolean): EdgeGeometry | null {
  const { geometry } = master;
  const versions = known.get(geometry) ?? new Map<string, EdgeGeometry | null>();
  known.set(geometry, versions);
  // Instances of a geometry differ in whether they bend.
  const key = [ifOpen, isDeformed(master), isSkinned(master), ...materialsOf(master).map((_, i) => isUsed(i))].join();
  const found = versions.get(key);
  if (found !== undefined) return found;
  const made = createEdgeGeometry(master, isUsed, ifOpen);
  versions.set(key, made);
  if (!made) return null;
  const dispose = (): void => {
    geometry.removeEventListener('dispose', dispose);
    versions.delete(key);
    made.geometry.dispose();
    for (const { value } of Object.values(made.uniforms)) value.dispose();
  };
  geometry.addEventListener('dispose', dispose);
  return made;
}

function createEdgeGeometry(master: Mesh, isUsed: (materialIndex: number) => boolean, ifOpen: boolean): EdgeGeometry | null {
  const whole = weldTriangles(master.geometry, isUsed);
  const isOpen = hasBorder(whole.triangles, whole.vertices.length);
  if (ifOpen && !isOpen) return null;
  const { mesh, positions, segments } = findLines(master, whole);
  const { attributes, morphAttributes, morphTargetsRelative } = master.geometry;
  const geometry = new BufferGeometry();
  // The shader reads no attributes. three.js reads the number of vertices, for the texture of morph targets, and the bounding sphere.
  if (attributes.position) geometry.setAttribute('position', attributes.position);
  Object.assign(geometry, { morphAttributes, morphTargetsRelative });
  geometry.setIndex(new BufferAttribute(quadIndices(segments.length), 1));
  const vertices = textureOf(vertexTexels(master, mesh, positions));
  const edges = textureOf(segmentTexels(segments));
  return { geometry, id: geometry.id, uniforms: { scrimVertices: { value: vertices }, scrimSegments: { value: edges } }, isOpen };
}

/** The segments of a mesh, or of one with fewer triangles where they are too many. */
function findLines(master: Mesh, whole: WeldedTriangles) {
  const wholePositions = restVertices(master, whole);
  const isDense = whole.triangles.length > MAX_TRIANGLES * 3;
  for (let most = FEWER_TRIANGLES; ; most /= 2) {
    // A mesh that is not dense may have too many edges, too: if its triangles hang together nowhere, as leaves.
    const mesh = isDense || most < FEWER_TRIANGLES ? withOnly(whole, simplify(whole.triangles, wholePositions, most)) : whole;
    const positions = mesh === whole ? wholePositions : restVertices(master, mesh);
    const edges = collectEdges(mesh.triangles, mesh.vertices.length);
    const segments = findSegments({ ...mesh, ...edges }, positions, isDeformed(master), MAX_SEGMENTS);
    if (segments) return { mesh, positions, segments };
  }
}

/** Some triangles of a mesh, and the vertices that they use. */
function withOnly({ vertices }: WeldedTriangles, triangles: Uint32Array): WeldedTriangles {
  const indexOf = new Map<number, number>();
  const used: number[] = [];
  const left = triangles.map((vertex) => {
    const index = indexOf.get(vertex) ?? used.length;
    if (index === used.length) used.push(vertices[vertex] ?? 0);
    indexOf.set(vertex, index);
    return index;
  });
  return { vertices: Uint32Array.from(used), triangles: left };
}

function quadIndices(count: number): Uint32Array {
  const indices = new Uint32Array(count * 6);
  for (let i = 0; i < count; i++) indices.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], i * 6);
  return indices;
}

/** One texel per vertex: its position, and its index in the mesh. Skinned meshes have two more: bones and their weights. */
function vertexTexels(master: Mesh, { vertices }: WeldedTriangles, positions: Float32Array): Float32Array {
  const { skinIndex, skinWeight } = master.geometry.attributes;
  const skins = isSkinned(master) && skinIndex && skinWeight ? [skinIndex, skinWeight] : [];
  const stride = 4 * (1 + skins.length);
  const texels = new Float32Array(vertices.length * stride);
  for (let i = 0; i < vertices.length; i++) {
    const vertex = vertices[i] ?? 0;
    texels.set(positions.subarray(i * 3, i * 3 + 3), i * stride);
    texels[i * stride + 3] = vertex;
    for (const [s, skin] of skins.entries()) {
      for (let c = 0; c < 4; c++) texels[i * stride + 4 * (s + 1) + c] = skin.getComponent(vertex, c);
    }
  }
  return texels;
}

/**
 * Three texels per segment: the vertices of the edge; where it is on the edge and in its stroke; the angle, the length of the stroke, and how
 * far apart lines lie at both ends.
 */
function segmentTexels(segments: readonly EdgeSegment[]): Float32Array {
  const texels = new Float32Array(segments.length * 12);
  for (const [i, { edge, from, to, alongFrom, alongTo, stroke, roomFrom, roomTo }] of segments.entries()) {
    const rooms = [Math.min(roomFrom, ROOMY), Math.min(roomTo, ROOMY)];
    texels.set([edge.a, edge.b, edge.c, edge.d, from, to, alongFrom, alongTo, edge.angle, stroke, ...rooms], i * 12);
  }
  return texels;
}

function textureOf(texels: Float32Array): DataTexture {
  const height = Math.max(1, Math.ceil(texels.length / 4 / WIDTH));
  const data = new Float32Array(WIDTH * height * 4);
  data.set(texels);
  const texture = new DataTexture(data, WIDTH, height, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
