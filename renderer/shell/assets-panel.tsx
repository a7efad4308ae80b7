import { type DragEvent, useEffect, useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { ExportedReport } from '../../app/contract/contract.ts';
import { ASSET_WORDS } from '../../nodes/kit/asset-words.ts';
import type { AssetKind } from '../../nodes/kit/definition.ts';
import { showCaptureReport } from '../state/acquisition/capture-report.ts';
import { canvasCenter } from '../state/commands/command-actions.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { acceptedNames } from '../state/files/add-files.ts';
import { type AssetRow, isUnused, listAssets, namesOfUses } from '../state/files/asset-rows.ts';
import { byteText } from '../state/files/byte-text.ts';
import {
  addAssetToGraph,
  canSimplify,
  goToUses,
  isFileKind,
  nameOf,
  refreshAssetFiles,
  removeUnused,
  replaceAsset,
  revealAsset,
  unusedAssets,
} from '../state/files/edit-assets.ts';
import { ASSET_DRAG } from '../state/graph/place-asset.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { AssetPicture, useAssetFacts } from './asset-picture.tsx';
import './assets-panel.css';

/** The files of the project: their sizes, the nodes that use them, and what can be done with them. */
export function AssetsPanel() {
  const editor = useEditor();
  const project = useDocument((state) => state.project);
  const library = useDocument((state) => state.library);
  const open = useDocument((state) => state.open);
  const exported = useStore(editor.ui, (state) => (state.exported?.handle === open?.handle ? state.exported : null));
  const { rows, others } = useMemo(() => listAssets({ project, library, open }), [project, library, open]);
  const handle = open?.handle;
  useEffect(() => {
    if (handle === undefined) return;
    const refresh = () => void refreshAssetFiles(editor);
    refresh();
    // Other programs may have changed the files.
    window.addEventListener('focus', refresh);
    return () => window.removeEventListener('focus', refresh);
  }, [editor, handle]);
  const isListed = rows.every(({ bytes }) => bytes !== null);
  useEffect(() => {
    // An import adds a file that the list does not have yet.
    if (!isListed) void refreshAssetFiles(editor);
  }, [editor, isListed]);
  const unused = rows.filter(isUnused);
  const inPage = (path: string) => exported?.report.assets.find((asset) => asset.path === path);
  if (rows.length === 0) {
    return <p className="assets-none">This project has no assets. Drop images, models, videos, sounds or panoramas on the graph.</p>;
  }
  return (
    <div className="assets scroll">
      <table aria-label="Assets">
        <thead>
          <tr>
            <th scope="col">Asset</th>
            <th scope="col">On disk</th>
            <th scope="col" data-tip="After compression, as of the last export">
              In the page
            </th>
            <th scope="col" data-tip="Textures with their mipmaps, and geometry, before compression">
              On the GPU
            </th>
            <th scope="col">Used by</th>
            <th scope="col">
              <span className="visually-hidden">Actions</span>
              <Button icon="trash" disabled={unused.length === 0} onPress={() => void removeUnused(editor, unusedAssets(editor))}>
                {unused.length === 0 ? 'Remove unused' : `Remove unused (${unused.length})`}
              </Button>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <Row key={row.id ?? row.path} row={row} inPage={inPage(row.path)} />
          ))}
        </tbody>
      </table>
      {others.length > 0 && <p className="assets-others">{othersText(others)}</p>}
    </div>
  );
}

function othersText(others: readonly { readonly bytes: number }[]): string {
  const size = byteText(others.reduce((sum, { bytes }) => sum + bytes, 0));
  const files = others.length === 1 ? '1 other file' : `${others.length} other files`;
  return `The folder assets has ${files} (${size}) that the project does not use. Exports leave them out.`;
}

interface RowProps {
  readonly row: AssetRow;
  /** The asset in the last exported page; undefined if it is not known. */
  readonly inPage: ExportedReport['assets'][number] | undefined;
}

function Row({ row, inPage }: RowProps) {
  const { path, kind, bytes, id } = row;
  const facts = useAssetFacts(row);
  const gpuBytes = facts.gpuBytes ?? (kind === 'splats' && inPage ? inPage.gpuBytes : null);
  // In a page, other captures and splats have their share.
  const phoneGpuBytes = inPage?.phoneGpuBytes ?? facts.phoneGpuBytes;
  const reduced = inPage?.reducedOnPhones.join(', ') ?? '';
  const onDragStart = (event: DragEvent) => {
    event.dataTransfer.setData(ASSET_DRAG, id ?? '');
    event.dataTransfer.effectAllowed = 'copy';
  };
  return (
    <tr draggable={id !== null} onDragStart={onDragStart}>
      <th scope="row">
        <span className="asset-name">
          <AssetPicture picture={facts.picture} kind={kind} missing={bytes === null} />
          <span className="asset-text">
            <span className="asset-file">{nameOf(path)}</span>
            <span className="asset-kind">{ASSET_WORDS[kind]}</span>
          </span>
        </span>
      </th>
      <td>{bytes === null ? <span className="asset-missing">Missing</span> : byteText(bytes)}</td>
      <td>{inPage === undefined ? '–' : byteText(inPage.bytes)}</td>
      <td>
        {gpuBytes === null ? '–' : byteText(gpuBytes)}
        {phoneGpuBytes !== null && (
          <span
            className="asset-phones"
            data-tip={`Captures and splats of a page share 128 MB on phones and headsets${reduced && `. There, this one ${reduced}`}`}
          >
            {byteText(phoneGpuBytes)} on phones
          </span>
        )}
      </td>
      <td>
        <Uses row={row} />
      </td>
      <td>{id !== null && <Actions row={row} id={id} />}</td>
    </tr>
  );
}

function Uses({ row }: { readonly row: AssetRow }) {
  const editor = useEditor();
  const { uses, shaders, path } = row;
  const nodes = uses.length === 1 ? '1 node' : `${uses.length} nodes`;
  const names = useDocument((state) => namesOfUses(state, uses).join(', '));
  return (
    <>
      {uses.length > 0 && (
        <button
          type="button"
          className="asset-uses"
          aria-label={`Go to ${nodes} with ${nameOf(path)}`}
          data-tip={names}
          onClick={() => goToUses(editor, row)}
        >
          {nodes}
        </button>
      )}
      {shaders.length > 0 && <span className="asset-shaders">{shaders.join(', ')}</span>}
      {uses.length + shaders.length === 0 && <span className="asset-unused">Nothing</span>}
    </>
  );
}

/** What can be done with an asset, by buttons. */
function Actions({ row, id }: { readonly row: AssetRow; readonly id: string }) {
  const editor = useEditor();
  const canReveal = useDocument((state) => state.canReveal);
  const { path, kind, bytes } = row;
  const name = nameOf(path);
  return (
    <span className="asset-actions">
      <IconButton
        icon="add"
        label={`Add a node with ${name}`}
        small
        onPress={() => void addAssetToGraph(editor, id, canvasCenter(editor))}
      />
      {kind === 'capture' && bytes !== null && (
        <IconButton icon="info" label={`Show what Scrim understood of ${name}`} small onPress={() => showCaptureReport(editor, path)} />
      )}
      {kind === 'capture' && (
        <IconButton
          icon="weight"
          label={`Rephotograph ${name}…`}
          small
          onPress={() => editor.ui.setState({ dialog: { kind: 'rephotograph', path } })}
        />
      )}
      {canSimplify(kind) && bytes !== null && (
        <IconButton
          icon="mesh"
          label={`Simplify ${name}…`}
          small
          onPress={() => editor.ui.setState({ dialog: { kind: 'simplify', id } })}
        />
      )}
      {isFileKind(kind) && <ReplaceButton id={id} kind={kind} label={bytes === null ? `Find ${name}…` : `Replace ${name}…`} />}
      {canReveal && bytes !== null && (
        <IconButton icon="folder" label={`Show ${name} in its folder`} small onPress={() => void revealAsset(editor, path)} />
      )}
      <IconButton icon="trash" label={`Remove ${name}`} small disabled={!isUnused(row)} onPress={() => void removeUnused(editor, [id])} />
    </span>
  );
}

interface ReplaceButtonProps {
  readonly id: string;
  readonly kind: Exclude<AssetKind, 'capture'>;
  readonly label: string;
}

function ReplaceButton({ id, kind, label }: ReplaceButtonProps) {
  const editor = useEditor();
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <IconButton icon="loop" label={label} small onPress={() => input.current?.click()} />
      <input
        ref={input}
        type="file"
        hidden
        accept={acceptedNames(kind)}
        // A glTF model may consist of several files.
        multiple={kind === 'model'}
        aria-label={label}
        onChange={(event) => {
          const files = [...(event.target.files ?? [])];
          event.target.value = '';
          if (files.length > 0) void replaceAsset(editor, id, files);
        }}
      />
    </>
  );
}
