import { type CaptureDocument, CaptureError, type CaptureMeshFile, readCapture } from '../../nodes/kit/capture.ts';
import { type AssetProblem, fileProblem } from './asset-problem.ts';
import { resolveInside } from './confine.ts';
import { statFile } from './read-file.ts';

/**
 * Checks the document of a capture in a project, and whether its files are there.
 *
 * @param root Real path of the project.
 * @param path Path of the document in the project.
 * @param text The document.
 */
export async function captureProblem(root: string, path: string, text: string): Promise<AssetProblem | null> {
  try {
    const folder = path.slice(0, path.lastIndexOf('/') + 1);
    return await captureFilesProblem(readCapture(text), folder, async (file) => resolveInside(root, folder + file));
  } catch (error) {
    if (!(error instanceof CaptureError)) throw error;
    const message = `${path} is not a valid capture: ${error.message}.`;
    return { code: 'SCR032', message, fix: 'Export it again, or choose another file.' };
  }
}

/**
 * The first file of a capture that is missing, is no file, is empty, or is a mesh of another size than its document says. Files of depth are
 * not needed to draw it.
 *
 * @param folder What messages begin paths with; ends in `/`.
 * @param resolve Gives the absolute path of a file of the capture.
 */
export async function captureFilesProblem(
  { mesh, views }: CaptureDocument,
  folder: string,
  resolve: (file: string) => Promise<string>,
): Promise<AssetProblem | null> {
  const expected: readonly (readonly [file: string, bytes: number | null])[] = [
    [mesh.file, meshBytes(mesh, 12)],
    ...views.flatMap(({ file, depthMesh, hiddenMesh }): (readonly [string, number | null])[] => [
      [file, null],
      ...(depthMesh ? [[depthMesh.file, meshBytes(depthMesh, 8)] as const] : []),
      ...(hiddenMesh ? [[hiddenMesh.file, meshBytes(hiddenMesh, 12)] as const] : []),
    ]),
  ];
  const problems = await Promise.all(
    expected.map(async ([file, bytes]): Promise<AssetProblem | null> => {
      const path = folder + file;
      try {
        const { size } = await statFile(await resolve(file));
        const fix = 'Import the capture again.';
        if (bytes !== null && size !== bytes)
          return { code: 'SCR032', message: `${path} has ${size} bytes, but capture.json says ${bytes}.`, fix };
        return size === 0 ? { code: 'SCR032', message: `${path} is empty.`, fix } : null;
      } catch (error) {
        return fileProblem(error, path);
      }
    }),
  );
  return problems.find((problem) => problem !== null) ?? null;
}

function meshBytes({ vertexCount, triangleCount }: CaptureMeshFile, bytesPerVertex: number): number {
  return bytesPerVertex * vertexCount + 12 * triangleCount;
}
