import { ModelError } from '../../export/gltf/document.ts';
import { findingsOf } from '../../export/gltf/findings.ts';
import { readWholeModel } from '../../export/gltf/whole-model.ts';
import { phantomNodes } from '../../export/program/phantom-nodes.ts';
import type { Program } from '../../export/program/program.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { readAssetFile } from './read-asset.ts';

/**
 * Checks the models of a program: invalid (SCR032), too large for phones (SCR034), or phantoms with open edges (SCR035). Skips the
 * models in `except`, which have diagnostics already.
 */
export async function checkModels(root: string, program: Program, except: ReadonlySet<string>): Promise<readonly Diagnostic[]> {
  const phantoms = phantomNodes(program);
  const standsForReal = new Set(
    program.operations.flatMap((operation) =>
      'assets' in operation && phantoms.has(operation.node) ? Object.values(operation.assets) : [],
    ),
  );
  const models = program.assets.filter(({ kind, path }) => kind === 'model' && !except.has(path));
  const found = await Promise.all(models.map(({ id, path }) => checkModel(root, path, standsForReal.has(id))));
  return found.flat();
}

async function checkModel(root: string, path: string, standsForReal: boolean): Promise<Diagnostic[]> {
  try {
    const { gltf, bytes } = await readWholeModel(await readAssetFile(root, path), path, (file) => readAssetFile(root, file));
    return findingsOf(gltf, path, bytes.length, standsForReal).map((finding) => ({ ...finding, file: path }));
  } catch (error) {
    if (!(error instanceof ModelError)) throw error;
    return [{ code: 'SCR032', severity: 'error', message: `${path} cannot be decoded: ${error.message}`, file: path }];
  }
}
