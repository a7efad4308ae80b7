import { basename, dirname, extname } from 'node:path';
import { readGltfMesh } from '../../../export/captures/mesh-gltf.ts';
import { meshAsGlb, weldMesh } from '../../../export/captures/write-glb.ts';
import { ModelError } from '../../../export/gltf/document.ts';
import { readWholeModel } from '../../../export/gltf/whole-model.ts';
import { CAPTURE_FILE, CaptureError, type CaptureMesh } from '../../../nodes/kit/capture.ts';
import { MAX_ASSET_BYTES } from '../../contract/call-parts.ts';
import type { HostInput, HostOutput } from '../../contract/contract.ts';
import { HostError } from '../../contract/host-error.ts';
import { resolveInside } from '../confine.ts';
import { errorCode, readRefusal, refusal } from '../file-errors.ts';
import type { FileLayer } from '../file-layer.ts';
import { withFreeCapture } from '../free-capture.ts';
import { importAsset } from '../import-asset.ts';
import { ASSETS_FOLDER } from '../project-files.ts';
import { readAssetFile } from '../read-asset.ts';
import { readBytes } from '../read-file.ts';
import { findTypedTool } from './outside-tools.ts';
import { copySimplified, readMeshOfCapture } from './simplify-capture.ts';
import { SIMPLIFIERS, simplifierVersion, simplifyMesh } from './simplify-mesh.ts';
import type { ToolEvents, ToolJobs } from './tool-jobs.ts';

/** Simplifications of the assets of a project by the editor. */
export interface SimplifyJobs {
  /**
   * The triangles of a model or capture, and whether the program is there.
   *
   * @param root Real path of the project.
   * @throws SCR004, SCR031, SCR069
   */
  look(root: string, asked: Omit<HostInput<'simplify.look'>, 'handle'>): Promise<HostOutput<'simplify.look'>>;
  /**
   * Writes a simpler asset beside the one before. `path` is null if it was canceled.
   *
   * @throws SCR004, SCR031, SCR060, SCR062, SCR066, SCR069, SCR078
   */
  run(projectId: string, client: string, job: SimplifyJob): Promise<HostOutput<'simplify.run'>>;
}

export interface SimplifyJob extends Omit<HostInput<'simplify.run'>, 'handle'>, ToolEvents {
  /** Real path of the project. */
  readonly root: string;
}

const CANCELED: HostOutput<'simplify.run'> = { path: null, before: 0, after: 0 };

export function createSimplifyJobs(files: FileLayer, tools: ToolJobs): SimplifyJobs {
  return {
    look: async (root, { path, program, executable }) => {
      const mesh = isCapture(path) ? await readMeshOfCapture(await folderOf(root, path)) : await readModel(root, path);
      const triangles = mesh.indices.length / 3;
      try {
        const found = await findTypedTool(SIMPLIFIERS[program], executable);
        const version = await simplifierVersion(program, found, new AbortController().signal);
        return { triangles, tool: `${version} (${found})`.trim(), diagnostic: null };
      } catch (error) {
        if (!(error instanceof HostError)) throw error;
        return { triangles, tool: null, diagnostic: error.diagnostic };
      }
    },
    run: (projectId, client, { onLines, ...job }) =>
      tools.run(projectId, client, {
        onLines,
        canceled: CANCELED,
        task: (interrupted, onLine) => simplify(job, files, interrupted, onLine),
      }),
  };
}

async function simplify(
  { root, path, program, executable, triangles, onProgress }: Omit<SimplifyJob, 'onLines'>,
  files: FileLayer,
  interrupted: AbortSignal,
  onLine: (line: string) => void,
): Promise<HostOutput<'simplify.run'>> {
  onProgress({ step: 'read', text: 'Reading the mesh…' });
  const tool = await findTypedTool(SIMPLIFIERS[program], executable);
  await simplifierVersion(program, tool, interrupted);
  const fewer = async (mesh: CaptureMesh): Promise<CaptureMesh> => {
    const say = (text: string) => onProgress({ step: 'simplify', text });
    const simple = await simplifyMesh(mesh, { program, path: tool, triangles, unwrap: false, format: '.ply', say, onLine, interrupted });
    interrupted.throwIfAborted();
    onProgress({ step: 'write', text: 'Writing the asset…' });
    return simple.mesh;
  };
  if (isCapture(path)) {
    const folder = await folderOf(root, path);
    return withFreeCapture(root, simpleName(basename(folder)), files, async (out) => {
      const counts = await copySimplified(folder, await resolveInside(root, out), files, fewer);
      return { path: `${out}/${CAPTURE_FILE}`, ...counts };
    });
  }
  const before = weldMesh(await readModel(root, path));
  const after = await fewer(before);
  const made = await importAsset(root, `${simpleName(basename(path))}.glb`, meshAsGlb(after), files);
  return { path: made, before: before.indices.length / 3, after: after.indices.length / 3 };
}

/** `robot.glb` becomes `robot-simple`, and so does a simple one. */
function simpleName(file: string): string {
  return `${file.slice(0, file.length - extname(file).length).replace(/-simple(-\d+)?$/, '')}-simple`;
}

function isCapture(path: string): boolean {
  return basename(path) === CAPTURE_FILE;
}

async function folderOf(root: string, path: string): Promise<string> {
  refuseOthers(path);
  return dirname(await resolveInside(root, path));
}

/** The triangles of a model, in its pose of rest. */
async function readModel(root: string, path: string): Promise<CaptureMesh> {
  refuseOthers(path);
  const file = await resolveInside(root, path);
  try {
    const { gltf } = await readWholeModel(await readBytes(file, MAX_ASSET_BYTES), path, (beside) => readAssetFile(root, beside));
    return readGltfMesh(gltf);
  } catch (error) {
    if (error instanceof CaptureError || error instanceof ModelError)
      throw refusal('SCR069', `${path} cannot be simplified: ${error.message.replace(/\.$/, '')}.`);
    throw errorCode(error) === undefined ? error : readRefusal(error, path);
  }
}

/** @throws SCR031 for what is no asset */
function refuseOthers(path: string): void {
  if (!path.startsWith(`${ASSETS_FOLDER}/`)) throw refusal('SCR031', `${path} is not an asset of the project.`);
}
