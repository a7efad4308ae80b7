import { companionOf, readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { moveImported } from '../../../export/glsl/language/header-edits.ts';
import { isShadertoy } from '../../../export/glsl/shadertoy/convert-shadertoy.ts';
import type { ModelBounds } from '../../../export/gltf/model-bounds.ts';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { makeAssetId } from '../../../export/graph/document-names.ts';
import type { Asset } from '../../../export/graph/project.ts';
import type { AssetKind } from '../../../nodes/kit/definition.ts';
import { type AddStep, apply, endGesture } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import type { Editor } from '../editor/editor.ts';
import { selectOnly } from '../editor/selection.ts';
import { addToast, toastDiagnostic } from '../editor/ui.ts';
import { type FloorPoint, floorInView, rightOnFloor } from '../graph/floor-point.ts';
import { placeAsset } from '../graph/place-asset.ts';
import { rowOnFloor } from '../graph/stand-on-floor.ts';
import { addShader, type ForeignShader } from '../shaders/add-shader.ts';
import { addShadertoy } from '../shaders/import-shadertoy.ts';
import { type Faces, joinFaces, splitFaces } from './cube-faces.ts';
import { showRefusal } from './files.ts';
import { addCube } from './import-cube.ts';
import { readBounds } from './model-animations.ts';
import { isGltf, type ModelFile, wholeModel } from './whole-models.ts';
import { packSog } from './whole-sog.ts';

/** Kinds of assets that are files. A capture is a folder, which `scrim import capture` makes. */
export type FileKind = Exclude<AssetKind, 'capture'>;

/**
 * File name endings by asset kind; the first match counts. `also`: further endings that a file input of this kind accepts, such as
 * images for panoramas, or the files that a model refers to.
 */
const KINDS: Readonly<Record<FileKind, { readonly endings: readonly string[]; readonly also?: readonly string[] }>> = {
  model: { endings: ['.glb', '.gltf'], also: ['.bin', '.png', '.jpg', '.jpeg', '.webp', '.ktx2'] },
  image: { endings: ['.png', '.jpg', '.jpeg', '.webp'] },
  video: { endings: ['.mp4', '.webm', '.m4v'] },
  audio: { endings: ['.mp3', '.m4a', '.wav', '.ogg', '.flac'] },
  splats: { endings: ['.ply', '.sog'], also: ['.json', '.webp'] },
  environment: { endings: ['.hdr', '.exr'], also: ['.jpg', '.jpeg', '.png', '.webp', '.avif'] },
};
const SHADERS = /\.(fs|isf|glsl)$/i;
const TABLES = /\.cube$/i;
/** Endings of files that may contain Shadertoy source. */
const SOURCES = /\.(fs|frag|glsl|json|txt)$/i;
const VERTEX_SHADER = /\.vs$/i;
const STEP_PX = 40;

export function kindOfFile(name: string): FileKind | 'shader' | null {
  if (SHADERS.test(name)) return 'shader';
  const lower = name.toLowerCase();
  const kinds = Object.keys(KINDS) as FileKind[];
  return kinds.find((kind) => KINDS[kind].endings.some((ending) => lower.endsWith(ending))) ?? null;
}

/** Value of the `accept` attribute of a file input. */
export function acceptedNames(kind: FileKind): string {
  const { endings, also = [] } = KINDS[kind];
  return [...endings, ...also].join();
}

/** The used part of `File`. */
export interface DroppedFile {
  readonly name: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/**
 * Adds each file as an asset or shader with a node, starting at `place`, as one undo step. A vertex shader belongs to the shader of the same
 * name, and images to the shader that imports them. Several models stand side by side.
 *
 * @param floor Where models stand. Default: in the middle of the view.
 */
export function addFiles(editor: Editor, files: readonly DroppedFile[], place: Place, floor?: FloorPoint): Promise<void> {
  return editor.fileWork(() => addEach(editor, files, place, floor));
}

async function addEach(editor: Editor, files: readonly DroppedFile[], place: Place, floor?: FloorPoint): Promise<void> {
  const added: string[] = [];
  const { faces, rest } = splitFaces(files);
  const sky = faces && (await joinedFaces(editor, faces));
  const { others, vertexOf, imagesOf } = await pairShaders(await packModels(editor, await packSplats(editor, rest)));
  const isOne = others.length + (sky ? 1 : 0) < 2;
  const step: AddStep = isOne ? {} : { label: 'Add files', key: `drop ${editor.document.getState().revision}` };
  const skyNode = sky && (await addAssetNode(editor, sky, 'environment', { place, step }));
  if (skyNode) added.push(skyNode);
  const standings = await standingsOf(editor, others, floor);
  for (const [index, file] of others.entries()) {
    const at = { x: place.x + index * STEP_PX, y: place.y + index * STEP_PX };
    const shadertoy = await readShadertoy(file);
    if (shadertoy !== null) {
      const node = addShadertoy(editor, { source: shadertoy, name: file.name.replace(/\.[^.]*$/, '') }, at, step);
      if (node !== null) added.push(node);
      continue;
    }
    if (TABLES.test(file.name)) {
      added.push(...(await addCube(editor, { name: file.name, text: await textOf(file) }, at, step)));
      continue;
    }
    const kind = kindOfFile(file.name);
    if (kind === null) {
      const text = VERTEX_SHADER.test(file.name)
        ? `${file.name} is a vertex shader without its ISF file. Drop both files together.`
        : `${file.name} has an unsupported format. Supported are models (.glb, .gltf), images (.png, .jpg, .webp), videos (.mp4, .webm), sounds (.mp3, .m4a, .wav, .ogg, .flac), panoramas (.hdr, .exr, or six faces of a cube), splats (.ply, .sog), LUTs (.cube) and ISF shaders (.fs).`;
      addToast(editor.ui, { tone: 'error', text });
      continue;
    }
    const node =
      kind === 'shader'
        ? addShader(editor, await readShaderFile(editor, file, vertexOf.get(file), imagesOf.get(file)), at, { step })
        : await addAssetNode(editor, file, kind, { place: at, step, ...standings.get(file) });
    if (node !== null) added.push(node);
  }
  endGesture(editor);
  if (added.length > 0) selectOnly(editor.selection, added);
}

/** The size of a model and the point of the floor where it stands. */
interface ModelStanding {
  readonly bounds: ModelBounds | null;
  readonly floor: FloorPoint | undefined;
}

/** Where the models among dropped files stand: one at the point, several in a row across the view. */
async function standingsOf(
  { preview }: Editor,
  files: readonly DroppedFile[],
  floor = floorInView(preview.getState().status),
): Promise<ReadonlyMap<DroppedFile, ModelStanding>> {
  const models = files.filter(({ name }) => kindOfFile(name) === 'model');
  const bounds = await Promise.all(models.map(async (file) => readBounds(new Uint8Array(await file.arrayBuffer()))));
  const row = rowOnFloor(floor, rightOnFloor(preview.getState().status), bounds);
  return new Map(models.map((file, i) => [file, { bounds: bounds[i] ?? null, floor: row[i] }]));
}

/** Shows a message and returns null if the faces do not make a panorama. */
async function joinedFaces(editor: Editor, faces: Faces): Promise<DroppedFile | null> {
  try {
    return await joinFaces(faces);
  } catch (error) {
    addToast(editor.ui, { tone: 'error', text: error instanceof Error ? error.message : String(error) });
    return null;
  }
}

/** Packs splats of several files into one file. Shows a message for incomplete ones and leaves them out. */
async function packSplats(editor: Editor, files: readonly DroppedFile[]): Promise<readonly DroppedFile[]> {
  const { sog, problem, rest } = await packSog(files);
  if (problem !== null) addToast(editor.ui, { tone: 'error', text: problem });
  return sog === null ? rest : [fileOf(sog), ...rest];
}

const MISSING_FIX = 'Import the model together with all of its files, or as one .glb file.';

/** Folder in which dropped files are assumed to lie. Dropped files have no folders, but references between them may contain `../`. */
const SOMEWHERE = 'a/b/c/';

/** Packs each `.gltf` and the files that it refers to into one file. Shows a message for incomplete models and leaves them out. */
async function packModels(editor: Editor, files: readonly DroppedFile[]): Promise<readonly DroppedFile[]> {
  const taken = new Set<DroppedFile>();
  const models: DroppedFile[] = [];
  for (const file of files.filter(({ name }) => isGltf(name))) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const beside = (path: string) => named(files, path.slice(path.lastIndexOf('/') + 1));
    const read = async (path: string) => {
      const found = beside(path);
      return found ? new Uint8Array(await found.arrayBuffer()) : null;
    };
    const whole = await wholeModel(`${SOMEWHERE}${file.name}`, bytes, MISSING_FIX, read);
    for (const used of [file, ...whole.beside.map(beside)]) if (used) taken.add(used);
    if (whole.diagnostic !== null) toastDiagnostic(editor.ui, whole.diagnostic);
    if (whole.file !== null) models.push(fileOf(whole.file));
  }
  return [...models, ...files.filter((file) => !taken.has(file))];
}

function fileOf({ name, bytes }: ModelFile): DroppedFile {
  return { name, arrayBuffer: async () => bytes.buffer };
}

/** Images that a shader imports, by the path in its header. */
type ShaderImages = ReadonlyMap<string, DroppedFile>;

interface PairedFiles {
  /** The files without the vertex shaders and images of shaders. */
  readonly others: readonly DroppedFile[];
  readonly vertexOf: ReadonlyMap<DroppedFile, DroppedFile>;
  readonly imagesOf: ReadonlyMap<DroppedFile, ShaderImages>;
}

async function pairShaders(files: readonly DroppedFile[]): Promise<PairedFiles> {
  const vertexOf = new Map<DroppedFile, DroppedFile>();
  const imagesOf = new Map<DroppedFile, ShaderImages>();
  const paired = new Set<DroppedFile>();
  for (const file of files) {
    if (!SHADERS.test(file.name)) continue;
    const vertex = named(files, companionOf(file.name));
    if (vertex) vertexOf.set(file, vertex);
    const imported = readIsf(await textOf(file), file.name).output?.imported ?? [];
    const images = new Map<string, DroppedFile>();
    for (const path of imported.flatMap(({ paths }) => paths)) {
      const image = named(files, path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1));
      if (image) images.set(path, image);
    }
    imagesOf.set(file, images);
    for (const used of [vertex, ...images.values()]) if (used) paired.add(used);
  }
  return { others: files.filter((file) => !paired.has(file)), vertexOf, imagesOf };
}

/** Finds a file by name. Dropped files have no folders. */
function named(files: readonly DroppedFile[], wanted: string): DroppedFile | undefined {
  return files.find(({ name }) => name.toLowerCase() === wanted.toLowerCase());
}

/** Reads a shader. Imports its images, and updates their paths in the header. */
async function readShaderFile(
  editor: Editor,
  file: DroppedFile,
  vertex: DroppedFile | undefined,
  images: ShaderImages = new Map(),
): Promise<ForeignShader> {
  const moved = new Map<string, string>();
  for (const [path, image] of images) {
    const imported = await importFile(editor, image, 'image');
    if (imported !== null) moved.set(path, `../${imported.path}`);
  }
  const text = moveImported(await textOf(file), moved);
  return { name: file.name, text, ...(vertex && { vertex: await textOf(vertex) }) };
}

/** The text of a file if it is Shadertoy source; else null. */
async function readShadertoy(file: DroppedFile): Promise<string | null> {
  if (!SOURCES.test(file.name)) return null;
  const text = await textOf(file);
  return isShadertoy(text) ? text : null;
}

async function textOf(file: DroppedFile): Promise<string> {
  return new TextDecoder().decode(await file.arrayBuffer());
}

/** Imports a file, or all files of a model, and adds an asset. Returns its id, or null if that failed. */
export function importAsset(editor: Editor, files: readonly DroppedFile[], kind: FileKind): Promise<string | null> {
  return editor.fileWork(async () => {
    const imported = await importWhole(editor, files, kind);
    if (imported === null) return null;
    const { project } = editor.document.getState();
    const id = makeAssetId(project, imported.path, editor.random);
    const name = imported.path.slice(imported.path.lastIndexOf('/') + 1);
    return apply(editor, `Import ${name}`, putAsset(project, { id, asset: imported })) ? id : null;
  });
}

/** Copies one file, all files of a model, or six faces of a panorama into the project. Returns null if that failed. */
export async function importWhole(editor: Editor, files: readonly DroppedFile[], kind: FileKind): Promise<Asset | null> {
  const { faces } = kind === 'environment' ? splitFaces(files) : { faces: null };
  const sky = faces && (await joinedFaces(editor, faces));
  if (faces && !sky) return null;
  const [first, ...others] = sky ? [sky] : await packModels(editor, await packSplats(editor, files));
  const file = [first, ...others].find((candidate) => candidate && kindOfFile(candidate.name) === kind) ?? first;
  return file ? importFile(editor, file, kind) : null;
}

async function importFile(editor: Editor, file: DroppedFile, kind: FileKind): Promise<Asset | null> {
  const { open } = editor.document.getState();
  if (open === null) return null;
  try {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { path } = await editor.host.call('asset.import', { handle: open.handle, name: file.name, bytes });
    return { path, kind };
  } catch (error) {
    showRefusal(editor, error);
    return null;
  }
}

interface AssetNodeOptions extends Partial<ModelStanding> {
  readonly place: Place;
  readonly step: AddStep;
}

/** Adds an asset and a node that outputs it, as one undo step. A model is also put into the scene, so that it is visible at once. */
async function addAssetNode(editor: Editor, file: DroppedFile, kind: FileKind, options: AssetNodeOptions): Promise<string | null> {
  const asset = await importFile(editor, file, kind);
  if (asset === null) return null;
  const id = makeAssetId(editor.document.getState().project, asset.path, editor.random);
  const { place, ...how } = options;
  return placeAsset(editor, { id, asset, ...how }, place);
}
