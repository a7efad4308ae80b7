import { type Place, phoneShares } from '../../export/bundle/assets/phone-shares.ts';
import { type LoadedCapture, loadCapture } from '../../export/runtime/assets/capture/load-capture.ts';
import { loadSplats } from '../../export/runtime/assets/splats/load-splats.ts';
import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { type CaptureDocument, captureMeshFile, meshCounts } from '../../nodes/kit/capture.ts';
import { createDepthMeshDrawing } from '../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import { createWindowedDrawing } from '../../nodes/kit/capture-drawing/windowed/windowed-drawing.ts';
import { type CaptureSize, captureSize } from '../../nodes/kit/capture-size.ts';
import { PHONE_GPU_BYTES } from '../../nodes/kit/phone-memory.ts';
import type { SplatAsset } from '../../nodes/kit/splat-asset.ts';
import { createSplatDrawing } from '../../nodes/kit/splat-drawing/splat-drawing.ts';
import { writeSplatFile } from '../../nodes/kit/splats/splat-file.ts';
import { HARMONICS_WORDS, WORDS } from '../../nodes/kit/splats/splats.ts';
import { bumpyBall, pattern, poseTowardsMiddle } from '../../tools/bench/pages/bumpy-capture.ts';
import { createGpuBytes } from '../../tools/bench/pages/gpu-bytes.ts';
import { createGl } from './scenes-kit.ts';

export interface Budget {
  readonly isCoarsePointer: boolean;
  /** What the textures and buffers of the capture and of its weights take. */
  readonly bytes: number;
  /** What the export says about phones, and about other devices. */
  readonly estimated: { readonly phones: CaptureSize; readonly others: CaptureSize };
  readonly photoPx: readonly [number, number];
  readonly triangles: number;
  readonly hasDepthMeshes: boolean;
  readonly error: number;
}

const VIEWS = 40;
const MAP = { widthPx: 1600, heightPx: 1200 };

/** A capture of a page with photographs of 2 megapixels, and the files beside its document. */
async function captureOf(vertexCount: number, depthTriangles: number, viewCount: number) {
  const mesh = bumpyBall(vertexCount);
  const coarse = bumpyBall(2000);
  const grid = depthGrid(depthTriangles);
  const views = Array.from({ length: viewCount }, (_, view) => ({
    file: `${view}.png`,
    ...MAP,
    fxPx: 1400,
    fyPx: 1400,
    cxPx: 800,
    cyPx: 600,
    worldFromCamera: [...poseTowardsMiddle([3 * Math.sin(view), 1, 3 * Math.cos(view)])],
    depthMesh: { file: `${view}.bin`, ...MAP, ...grid.counts },
  }));
  const document: CaptureDocument = {
    format: 'scrim-capture',
    version: 2,
    mesh: { file: 'mesh.bin', ...meshCounts(mesh) },
    views,
    coarseMesh: { file: 'coarse.bin', ...meshCounts(coarse) },
    phoneGpuBytes: PHONE_GPU_BYTES,
  };
  const photo = await pattern(1);
  const files: Readonly<Record<string, Uint8Array>> = { 'mesh.bin': captureMeshFile(mesh), 'coarse.bin': captureMeshFile(coarse) };
  const read = async (path: string): Promise<ArrayBuffer> =>
    Uint8Array.from(files[path] ?? (path.endsWith('.bin') ? grid.bytes : new Uint8Array(photo))).buffer;
  return { document, read };
}

/** Loads a capture of a page with 40 photographs, and draws it for two eyes. */
export async function load(vertexCount: number, depthTriangles: number, isWindowed: boolean): Promise<Budget> {
  const { document, read } = await captureOf(vertexCount, depthTriangles, VIEWS);
  const gl = createGl(64, 48);
  const counted = createGpuBytes(gl);
  const objects = createGlObjects(gl);
  const capture: LoadedCapture = await loadCapture(
    objects,
    new TextEncoder().encode(JSON.stringify(document)).buffer,
    'c.json',
    read,
    !isWindowed,
  );
  const drawing = isWindowed ? createWindowedDrawing(gl, capture, 2, 4, { deltaS: 0, held: false }) : createDepthMeshDrawing(gl, capture);
  const clip = Float32Array.of(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0);
  for (const viewIndex of [0, 1]) {
    const target = { framebuffer: null, viewport: { x: 0, y: 0, widthPx: 4, heightPx: 4 }, viewIndex };
    drawing.draw(clip, Float32Array.of(0, 0, 3), Float32Array.of(0, 0, -1), target);
  }
  const use = { maxSidePx: objects.limits.maxTextureSizePx, depthMeshes: !isWindowed };
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, capture.photos);
  const result = {
    isCoarsePointer: matchMedia('(pointer: coarse)').matches,
    bytes: counted.textures() + counted.buffers(),
    estimated: { phones: captureSize(document, { ...use, mostBytes: PHONE_GPU_BYTES }), others: captureSize(document, use) },
    photoPx: sizeOfPhotos(gl, capture.photos),
    triangles: capture.indexCount / 3,
    hasDepthMeshes: capture.depthMeshes !== null,
    error: gl.getError(),
  };
  drawing.dispose();
  capture.dispose();
  if (counted.textures() + counted.buffers() !== 0) throw new Error('The capture left textures or buffers.');
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return result;
}

export interface Together {
  readonly isCoarsePointer: boolean;
  /** What the textures and buffers of both captures and of the splats take. */
  readonly bytes: number;
  readonly photosPx: readonly (readonly [number, number])[];
  readonly splats: Pick<SplatAsset, 'count' | 'degree'>;
  readonly error: number;
}

const SPLATS = 700_000;

/** Loads two captures and splats that share the memory of a phone as in an exported page. */
export async function loadTogether(): Promise<Together> {
  const captures = await Promise.all([captureOf(20_000, 2, 8), captureOf(30_000, 2, 8)]);
  const places: readonly Place[] = [
    ...captures.map(({ document }, i): Place => ({ asset: { id: `${i}`, kind: 'capture', path: `${i}.json` }, capture: document })),
    { asset: { id: 'splats', kind: 'splats', path: 'splats' }, capture: null, splats: { count: SPLATS, degree: 3 } },
  ];
  const shares = [...phoneShares(places).values()];
  const gl = createGl(64, 48);
  const counted = createGpuBytes(gl);
  const objects = createGlObjects(gl);
  const loaded: LoadedCapture[] = [];
  for (const [i, { document, read }] of captures.entries()) {
    const limited: CaptureDocument = { ...document, phoneGpuBytes: shares[i] ?? 0 };
    loaded.push(await loadCapture(objects, new TextEncoder().encode(JSON.stringify(limited)).buffer, 'c.json', read, false));
  }
  const splats = await loadSplats(objects, await splatFile(), 'garden.splats', shares[2]);
  const drawing = createSplatDrawing(gl, splats, false, null);
  const result = {
    isCoarsePointer: matchMedia('(pointer: coarse)').matches,
    bytes: counted.textures() + counted.buffers(),
    photosPx: loaded.map(({ photos }) => {
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, photos);
      return sizeOfPhotos(gl, photos);
    }),
    splats: { count: splats.count, degree: splats.degree },
    error: gl.getError(),
  };
  for (const one of [drawing, splats, ...loaded]) one.dispose();
  if (counted.textures() + counted.buffers() !== 0) throw new Error('The places left textures or buffers.');
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return result;
}

/** A file of equal splats with all harmonics, in the form of pages. */
async function splatFile(): Promise<ArrayBuffer> {
  const words = new Uint32Array(SPLATS * WORDS).fill(0x3c003c00);
  const harmonics = new Uint32Array(SPLATS * HARMONICS_WORDS[3]).fill(0x80808080);
  const content = writeSplatFile({ count: SPLATS, degree: 3, antialiased: false, words, harmonics, ranges: [1, 1, 1], invalid: 0 });
  return new Response(new Blob([content]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer();
}

/** The size of a texture array, which only a shader knows. */
function sizeOfPhotos(gl: WebGL2RenderingContext, photos: WebGLTexture): readonly [number, number] {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, photos, 0, 0);
  const isInside = (x: number, y: number): boolean => {
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel.fill(0));
    return pixel[3] === 255;
  };
  const pixel = new Uint8Array(4);
  const length = (isIn: (at: number) => boolean): number => {
    let [least, most] = [0, 4096];
    while (least < most) {
      const middle = (least + most) >> 1;
      if (isIn(middle)) least = middle + 1;
      else most = middle;
    }
    return least;
  };
  const size = [length((x) => isInside(x, 0)), length((y) => isInside(0, y))] as const;
  gl.deleteFramebuffer(framebuffer);
  return size;
}

/** A flat depth mesh of about so many triangles. */
function depthGrid(triangles: number) {
  const side = Math.max(1, Math.round(Math.sqrt(triangles / 2)));
  const vertexCount = (side + 1) ** 2;
  const indices: number[] = [];
  const bytes = new ArrayBuffer(8 * vertexCount + 24 * side * side);
  const [places, depths] = [new Uint16Array(bytes, 0, 4 * vertexCount), new Float32Array(bytes, 0, 2 * vertexCount)];
  for (let at = 0; at < vertexCount; at++) {
    const [column, row] = [at % (side + 1), Math.floor(at / (side + 1))];
    depths[2 * at + 1] = 2;
    places.set([Math.floor((2 * MAP.widthPx * column) / side), Math.floor((2 * MAP.heightPx * row) / side)], 4 * at);
    if (column < side && row < side) indices.push(at, at + side + 1, at + 1, at + 1, at + side + 1, at + side + 2);
  }
  new Uint32Array(bytes, 8 * vertexCount).set(indices);
  return { bytes: new Uint8Array(bytes), counts: { vertexCount, triangleCount: indices.length / 3 } };
}
