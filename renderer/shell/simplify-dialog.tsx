import { useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { countText, lookAtMesh, type Simplifier, type SimplifyLook, simplifyAsset } from '../state/acquisition/simplify-asset.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import type { ProgramPath } from '../state/editor/preferences.ts';
import { canSimplify, nameOf } from '../state/files/edit-assets.ts';
import { ChoiceField, TextField } from '../ui/form-fields.tsx';
import { ProgramField, problemText, ToolDialog, useAnswer } from './tool-dialog.tsx';

const PROGRAMS: Readonly<Record<Simplifier, { readonly title: string; readonly preference: ProgramPath }>> = {
  blender: { title: 'Blender', preference: 'blender' },
  'instant-meshes': { title: 'Instant Meshes', preference: 'instantMeshes' },
};
const PROGRAM_OPTIONS = (Object.keys(PROGRAMS) as Simplifier[]).map((value) => ({ value, label: PROGRAMS[value].title }));
const LEAST_TRIANGLES = 4;

/** Makes a model or a capture smaller. `id`: the chosen asset; absent: the first. */
export function SimplifyDialog({ id: given, onClose }: { readonly id: string | undefined; readonly onClose: () => void }) {
  const editor = useEditor();
  const assets = useDocument(({ project }) => project.assets);
  const options = useMemo(
    () => Object.entries(assets).flatMap(([value, asset]) => (canSimplify(asset.kind) ? [{ value, label: nameOf(asset.path) }] : [])),
    [assets],
  );
  const [id, setId] = useState(given ?? options[0]?.value ?? '');
  const [program, setProgram] = useState<Simplifier>('blender');
  const [typed, setTyped] = useState<string | null>(null);
  const [result, setResult] = useState<'new' | 'replace'>('new');
  const { title, preference } = PROGRAMS[program];
  const executable = useStore(editor.preferences, (state) => state[preference]).trim();
  const asset = assets[id];
  const path = asset?.path ?? '';
  const look = useAnswer(path === '' ? null : JSON.stringify([path, program, executable]), () =>
    lookAtMesh(editor, path, program, executable),
  );
  const found = look !== null && 'triangles' in look ? look : null;
  const text = typed ?? (found ? String(Math.max(LEAST_TRIANGLES, Math.round(found.triangles / 2))) : '');
  const triangles = Number(text);
  const wrong = found === null ? undefined : problemOf(triangles, found.triangles);
  const choose = (chosen: string) => {
    setId(chosen);
    setTyped(null);
  };
  return (
    <ToolDialog
      kind="simplify"
      title="Simplify a model"
      action="Simplify"
      program={title}
      steps={[
        { step: 'read', label: 'Mesh' },
        { step: 'simplify', label: title },
        { step: 'write', label: 'Asset' },
      ]}
      ready={found !== null && found.tool !== null && wrong === undefined}
      onGo={() => void simplifyAsset(editor, { id, program, executable, triangles, replaces: result === 'replace' })}
      onClose={onClose}
    >
      <ChoiceField label="Asset" value={id} options={options} onChoose={choose} />
      <div className="form-row">
        <TextField label="Triangles, at most" text={text} error={wrong} onChange={setTyped} />
        <ChoiceField label="Program" value={program} options={PROGRAM_OPTIONS} onChoose={setProgram} />
      </div>
      <ProgramField title={title} preference={preference} problem={found?.diagnostic} />
      <ChoiceField
        label="Result"
        value={result}
        options={[
          { value: 'new', label: 'A new asset' },
          { value: 'replace', label: `Replaces ${nameOf(path)} in all nodes` },
        ]}
        onChoose={setResult}
      />
      <p className="dialog-note" role="status">
        {lookWords(look, title)}
      </p>
      <p className="dialog-note">
        {asset?.kind === 'capture'
          ? 'The photographs are copied. The files of the capture before stay, so that undo brings it back.'
          : 'The result has the shape alone, without materials, textures and animations. The file before stays, so that undo brings it back.'}
      </p>
    </ToolDialog>
  );
}

function problemOf(triangles: number, before: number): string | undefined {
  if (!Number.isInteger(triangles) || triangles < LEAST_TRIANGLES) return `Enter a whole number from ${LEAST_TRIANGLES} on.`;
  return triangles >= before ? 'It has no more triangles than that.' : undefined;
}

function lookWords(look: SimplifyLook | null, title: string): string {
  if (look === null) return 'Reading the mesh…';
  if (!('triangles' in look)) return problemText(look);
  const count = `${countText(look.triangles)} triangles.`;
  return look.tool === null ? count : `${count} ${title} ${look.tool} makes them fewer.`;
}
