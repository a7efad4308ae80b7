import { readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import {
  type CaptureDocument,
  CaptureError,
  type CaptureView,
  captureMeshFile,
  meshCounts,
  readCapture,
  readCaptureMesh,
} from '../../../nodes/kit/capture.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { PHONE_GPU_BYTES } from '../../../nodes/kit/phone-memory.ts';
import { openSog } from '../../../nodes/kit/splats/sog-archive.ts';
import { SPLAT_FILE_ENDING, writeSplatFile } from '../../../nodes/kit/splats/splat-file.ts';
import { readSplatPly } from '../../../nodes/kit/splats/splat-ply.ts';
import { SplatError, type Splats } from '../../../nodes/kit/splats/splats.ts';
import { DECODER_FILES, DECODER_FILES_FOLDER, DECODERS, type DecoderFile, type DecoderName, neededDecoders } from '../../gltf/decoders.ts';
import { ModelError } from '../../gltf/document.ts';
import { imageSize } from '../../gltf/image-size.ts';
import { mayHaveBorders } from '../../gltf/open-edges.ts';
import { readGltf } from '../../gltf/read-gltf.ts';
import { readWholeModel } from '../../gltf/whole-model.ts';
import type { ProgramAsset } from '../../program/program.ts';
import type { CompressedModel } from '../compress/compressed-model.ts';
import { createCompressor } from '../compress/compressor.ts';
import { hashedName } from '../hashed-name.ts';
import { type ModelUse, modelUse } from '../model-use.ts';
import { createPhotoWorkers } from '../photos/photo-workers.ts';
import { chooseForms, type Form, gpuBytesOf } from './choose-forms.ts';
import { coarseMesh, reducedPhoto } from './coarse-capture.ts';
import { type AssetCache, remembered } from './model-cache.ts';
import { phoneReductions, reducedPlaces } from './page-memory.ts';
import { phoneShares, sizeOfCapture, sizeOfSplats } from './phone-shares.ts';
import type { PreparedAsset } from './prepared-asset.ts';

export interface AssetOptions {
  /** Absolute path of the folder with Scrim's sources and `node_modules`. */
  readonly root: string;
  /** Reads a file by its project path. Rejects with an `Error` whose message is text for the user. */
  readonly readAsset: (path: string) => Promise<Uint8Array>;
  /** Whether to compress models. Models of several files become one in any case. */
  readonly compress: boolean;
  readonly cache: AssetCache | null;
  /** Whether the page loads files one by one, so that it shows a capture before all of it has arrived. A page of one file does not. */
  readonly streams: boolean;
  /** Whether it matters which models have surfaces with a border; otherwise all count as having some. Default: false. */
  readonly findsBorders?: boolean;
  /** Receives progress texts. */
  readonly say: (text: string) => void;
}

export interface PreparedAssets {
  readonly assets: readonly PreparedAsset[];
  /** Decoders that the models need. */
  readonly decoders: readonly DecoderName[];
  readonly models: ModelUse;
  /** Files of the decoders with their paths in the page. */
  readonly decoderFiles: readonly { readonly file: DecoderFile; readonly path: string; readonly bytes: Uint8Array }[];
}

interface ReadAsset {
  readonly asset: ProgramAsset;
  /** One GLB, also for models of several files. */
  readonly bytes: Uint8Array;
  /** Size of all its files in the project. */
  readonly fileBytes: number;
  readonly others: PreparedAsset['others'];
  /** The document of a capture. */
  readonly capture: CaptureDocument | null;
  /** What a file of splats has, and its ending in the page. */
  readonly splats?: Pick<Splats, 'count' | 'degree'> & { readonly ending: string };
}

/** Smaller models are not compressed, because the decoder would cost more. */
const MIN_MODEL_BYTES = 16_000;

/**
 * Reads the assets of a page and compresses its models without visible loss. SCR030 for an unreadable file, SCR032 for an invalid model,
 * SCR036 (warning) for a model that cannot be compressed and is used as it is, SCR034 (info) for what phones show less of a place.
 */
export async function prepareAssets(assets: readonly ProgramAsset[], options: AssetOptions): Promise<Result<PreparedAssets>> {
  const read: ReadAsset[] = [];
  const diagnostics: Diagnostic[] = [];
  for (const asset of assets) {
    try {
      read.push(await readAsset(asset, options));
    } catch (error) {
      diagnostics.push(unreadable(asset, error));
    }
  }
  if (diagnostics.length > 0) return { output: null, diagnostics };
  const shares = phoneShares(read);
  const limited = read.map((one) => withLimit(one, shares.get(one)));
  const forms = await formsOf(limited, options, diagnostics);
  const prepared = limited.map((one) => prepare(one, forms.get(one) ?? { form: 'original', bytes: one.bytes }));
  diagnostics.push(...reducedPlaces(prepared));
  const models = prepared.filter(({ asset }) => asset.kind === 'model');
  const documents = models.map(({ bytes }) => readGltf(bytes).document);
  const needed = new Set(documents.flatMap(neededDecoders));
  const decoders = DECODERS.filter((name) => needed.has(name));
  // Before they are compressed. Vertices with equal values still have equal ones afterwards.
  const open = !options.findsBorders || read.some(({ asset, bytes }) => asset.kind === 'model' && mayHaveBorders(readGltf(bytes)));
  return {
    output: { assets: prepared, decoders, models: modelUse(documents, open), decoderFiles: await readDecoders(options.root, decoders) },
    diagnostics,
  };
}

async function readAsset(asset: ProgramAsset, options: AssetOptions): Promise<ReadAsset> {
  const { readAsset: readFileOf } = options;
  const bytes = await readFileOf(asset.path);
  if (asset.kind === 'capture') return readCaptureFiles(asset, bytes, options);
  if (asset.kind === 'splats') return readSplats(asset, Uint8Array.from(bytes));
  if (asset.kind !== 'model') return { asset, bytes, fileBytes: bytes.length, others: [], capture: null };
  let fileBytes = bytes.length;
  const model = await readWholeModel(Uint8Array.from(bytes), asset.path, async (path) => {
    const beside = await readFileOf(path);
    fileBytes += beside.length;
    return beside;
  });
  return { asset, bytes: model.bytes, fileBytes, others: [], capture: null };
}

/** A capture whose mesh and photographs are smaller together is loaded at once: over 1.6 Mbit/s in 2.5 s. */
const MIN_STREAMED_BYTES = 500_000;

/**
 * Reads the files of a capture, and names them in its document by their paths in the page. For a page that streams, adds a coarse mesh and
 * reduced photographs, which it draws while the others load.
 */
async function readCaptureFiles(asset: ProgramAsset, bytes: Uint8Array, options: AssetOptions): Promise<ReadAsset> {
  const { readAsset: read, streams } = options;
  const document = readCapture(new TextDecoder().decode(bytes));
  const folder = asset.path.slice(0, asset.path.lastIndexOf('/') + 1);
  const name = captureName(asset.path);
  const others: { path: string; bytes: Uint8Array }[] = [];
  let fileBytes = bytes.length;
  const put = (file: string, content: Uint8Array): string => {
    const path = hashedName(`assets/${name}-${fileName(file)}`, content);
    others.push({ path, bytes: content });
    return fileName(path);
  };
  const add = async (file: string): Promise<Uint8Array> => {
    const content = await read(folder + file);
    fileBytes += content.length;
    return content;
  };
  const meshBytes = await add(document.mesh.file);
  const photos: Uint8Array[] = [];
  for (const { file } of document.views) photos.push(await add(file));
  const isStreamed = streams && fileBytes >= MIN_STREAMED_BYTES;
  const reducedPhotos = isStreamed ? await reduceAll(asset.path, photos, document.views, options) : [];
  const views: CaptureView[] = [];
  for (const [i, { depth: _, depthMesh, hiddenMesh, ...view }] of document.views.entries()) {
    const photo = photos[i] ?? new Uint8Array();
    const reduced = reducedPhotos[i];
    views.push({
      ...view,
      file: put(view.file, photo),
      ...(reduced ? { reducedFile: put(view.file.replace(/\.\w+$/, '-reduced.avif'), reduced) } : {}),
      ...(asset.depthMeshes && depthMesh ? { depthMesh: { ...depthMesh, file: put(depthMesh.file, await add(depthMesh.file)) } } : {}),
      ...(asset.depthMeshes && hiddenMesh ? { hiddenMesh: { ...hiddenMesh, file: put(hiddenMesh.file, await add(hiddenMesh.file)) } } : {}),
    });
  }
  if (asset.depthMeshes && !views.some(({ depthMesh }) => depthMesh)) throw new CaptureError('it has no depth meshes. Import it again');
  const whole = readCaptureMesh(document.mesh, Uint8Array.from(meshBytes).buffer);
  const mesh = { ...document.mesh, file: put(document.mesh.file, meshBytes) };
  const coarse = isStreamed ? await coarseMesh(whole) : null;
  const first = coarse ? { ...meshCounts(coarse), file: put('coarse-mesh.bin', captureMeshFile(coarse)) } : mesh;
  const limit = { phoneGpuBytes: PHONE_GPU_BYTES };
  const renamed: CaptureDocument = { ...document, ...limit, mesh, views, ...(isStreamed ? { coarseMesh: first } : {}) };
  return { asset, bytes: new TextEncoder().encode(JSON.stringify(renamed)), fileBytes, others, capture: renamed };
}

/** Writes the memory on phones and headsets to the document of a capture, or to the asset of splats. */
function withLimit(read: ReadAsset, phoneGpuBytes: number | undefined): ReadAsset {
  if (phoneGpuBytes === undefined) return read;
  if (!read.capture) return { ...read, asset: { ...read.asset, phoneGpuBytes } };
  const capture = { ...read.capture, phoneGpuBytes };
  return { ...read, capture, bytes: new TextEncoder().encode(JSON.stringify(capture)) };
}

async function reduceAll(path: string, photos: readonly Uint8Array[], views: readonly CaptureView[], { root, cache, say }: AssetOptions) {
  const workers = createPhotoWorkers(root, Math.max(...views.map(({ widthPx, heightPx }) => widthPx * heightPx)));
  let reduced = 0;
  try {
    return await Promise.all(
      photos.map(async (photo) => {
        const made = await reducedPhoto(photo, cache, workers);
        say(`Reducing the photographs of ${path} (${++reduced} of ${photos.length})…`);
        return made;
      }),
    );
  } finally {
    await workers.dispose();
  }
}

/** Packs the splats of a PLY file for the GPU. A SOG file is smaller than that, and stays as it is. */
async function readSplats(asset: ProgramAsset, bytes: Uint8Array<ArrayBuffer>): Promise<ReadAsset> {
  const base = { asset, fileBytes: bytes.length, others: [], capture: null };
  if (asset.path.toLowerCase().endsWith('.sog')) {
    const { count, harmonics } = (await openSog(bytes)).meta;
    return { ...base, bytes, splats: { count, degree: harmonics?.degree ?? 0, ending: '.sog' } };
  }
  const splats = readSplatPly(bytes);
  const packed = gzipSync(writeSplatFile(splats), { level: 9 });
  return { ...base, bytes: packed, splats: { count: splats.count, degree: splats.degree, ending: SPLAT_FILE_ENDING } };
}

/** `room` for `assets/room.capture/capture.json`. */
function captureName(path: string): string {
  return fileName(path.slice(0, path.lastIndexOf('/'))).replace(/\.capture$/, '');
}

async function formsOf(read: readonly ReadAsset[], { root, compress, cache, say }: AssetOptions, diagnostics: Diagnostic[]) {
  const models = read.filter(({ asset }) => asset.kind === 'model');
  const total = models.reduce((sum, { bytes }) => sum + bytes.length, 0);
  if (!compress || total < MIN_MODEL_BYTES) return new Map<ReadAsset, never>();
  const compressor = createCompressor(root);
  try {
    const forms: { original: Uint8Array; compressed: CompressedModel }[] = [];
    for (const [i, model] of models.entries()) {
      const { asset, bytes } = model;
      const make = () => {
        say(`Compressing ${asset.path} (${i + 1} of ${models.length})…`);
        return compressor.compress(bytes);
      };
      const compressed = await remembered(cache, bytes, make).catch((error: unknown) => {
        diagnostics.push(uncompressed(asset, error));
        return NOTHING;
      });
      forms.push({ original: bytes, compressed });
    }
    const chosen = chooseForms(forms);
    return new Map(models.map((model, i) => [model, chosen[i]]));
  } finally {
    await compressor.dispose();
  }
}

const NOTHING: CompressedModel = { meshopt: null, ktx2: null };

function prepare(read: ReadAsset, { form, bytes }: { readonly form: Form; readonly bytes: Uint8Array }): PreparedAsset {
  const { asset, bytes: original, fileBytes, others, capture, splats } = read;
  const plain = fileName(asset.path).replace(/\.gltf$/i, '.glb');
  const name = capture ? `${captureName(asset.path)}.json` : splats ? plain.replace(/\.\w+$/, splats.ending) : plain;
  const path = hashedName(`assets/${name}`, bytes);
  const sizeOf = (mostBytes: number | undefined) => sizeOfCapture(read, mostBytes) ?? sizeOfSplats(read, mostBytes);
  const limit = capture?.phoneGpuBytes ?? asset.phoneGpuBytes;
  const reduced = limit === undefined ? [] : phoneReductions(read, limit);
  const gpu = (content: Uint8Array) => {
    const size = sizeOf(undefined);
    if (size) return size.gpuBytes;
    return asset.kind === 'model' ? gpuBytesOf(content) : imagesGpuBytes(content);
  };
  const report = {
    source: asset.path,
    path,
    kind: asset.kind,
    form,
    fileBytes: { before: fileBytes, after: others.reduce((sum, other) => sum + other.bytes.length, bytes.length) },
    gpuBytes: {
      before: gpu(original),
      after: gpu(bytes),
      ...(limit === undefined ? {} : { onPhones: sizeOf(limit)?.gpuBytes ?? 0 }),
    },
    ...(reduced.length > 0 ? { reducedOnPhones: reduced } : {}),
  };
  const copyright = asset.kind === 'model' ? (readGltf(original).document.asset?.copyright ?? '') : '';
  return { asset, path, bytes, others, copyright, report };
}

/** GPU memory of an image asset, which has no mipmaps. */
function imagesGpuBytes(bytes: Uint8Array): number {
  const size = imageSize(bytes);
  return size ? size.widthPx * size.heightPx * 4 : 0;
}

async function readDecoders(root: string, decoders: readonly DecoderName[]): Promise<PreparedAssets['decoderFiles']> {
  const files = decoders.flatMap((name): readonly DecoderFile[] => DECODER_FILES[name]);
  return Promise.all(
    files.map(async (file) => {
      const bytes = await readFile(join(root, DECODER_FILES_FOLDER, file));
      return { file, path: hashedName(`decoders/${basename(file)}`, bytes), bytes };
    }),
  );
}

function unreadable({ path }: ProgramAsset, error: unknown): Diagnostic {
  const reason = error instanceof Error ? error.message : String(error);
  if (error instanceof SplatError) {
    return { code: 'SCR032', severity: 'error', message: `${path} cannot be shown: ${reason}.`, file: path, fix: error.fix };
  }
  if (error instanceof ModelError || error instanceof CaptureError)
    return { code: 'SCR032', severity: 'error', message: `${path} cannot be decoded: ${reason}`, file: path };
  return { code: 'SCR030', severity: 'error', message: `${path} cannot be read: ${reason}`, file: path };
}

function uncompressed({ path }: ProgramAsset, error: unknown): Diagnostic {
  const reason = error instanceof Error ? error.message : String(error);
  return {
    code: 'SCR036',
    severity: 'warning',
    message: `${path} could not be compressed, so the page contains the original: ${reason.replace(/\.$/, '')}.`,
    file: path,
    fix: 'Export it again from the program that made it.',
  };
}

/** Restricts a name to characters that every host and file system supports. */
function fileName(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1).replace(/[^A-Za-z0-9._-]+/g, '-');
}
