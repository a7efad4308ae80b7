import { useMemo, useState } from 'react';
import { useStore } from 'zustand';
import type { RephotographMethod } from '../../export/captures/evaluate/rephotograph.ts';
import { rephotographCapture, showRephotographReport } from '../state/acquisition/rephotograph-capture.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import type { RephotographMeans } from '../state/editor/ui.ts';
import { nameOf } from '../state/files/edit-assets.ts';
import { Button } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { FormDialog } from '../ui/form-dialog.tsx';
import { ChoiceField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import './rephotograph-dialogs.css';

/** As the node Capture calls them. */
const METHOD_WORDS: Readonly<Record<RephotographMethod, string>> = {
  plain: 'Plain',
  nearest: 'Nearest',
  lumigraph: 'Lumigraph',
  'depth-meshes': 'Depth meshes',
};
const METHODS: readonly SelectOption<RephotographMethod | 'all'>[] = [
  { value: 'all', label: 'All' },
  ...(Object.keys(METHOD_WORDS) as RephotographMethod[]).map((value) => ({ value, label: METHOD_WORDS[value] })),
];
const BLENDED = ['1', '2', '3', '4'].map((value) => ({ value, label: value }));

/** Which capture is rephotographed, and how. `path`: the chosen capture; absent: the first. */
export function RephotographDialog({ path, onClose }: { readonly path: string | undefined; readonly onClose: () => void }) {
  const editor = useEditor();
  const assets = useDocument(({ project }) => project.assets);
  const busy = useStore(editor.ui, ({ exporting }) => exporting !== null);
  const captures = useMemo(
    () => Object.values(assets).flatMap((asset) => (asset.kind === 'capture' ? [{ value: asset.path, label: nameOf(asset.path) }] : [])),
    [assets],
  );
  const [capture, setCapture] = useState(path ?? captures[0]?.value ?? '');
  const [method, setMethod] = useState<RephotographMethod | 'all'>('all');
  const [blended, setBlended] = useState('2');
  const go = () => void rephotographCapture(editor, { path: capture, method: method === 'all' ? null : method, blended: Number(blended) });
  return (
    <FormDialog title="Rephotograph a capture" action="Rephotograph" ready={capture !== '' && !busy} onGo={go} onClose={onClose}>
      <ChoiceField label="Capture" value={capture} options={captures} onChoose={setCapture} />
      <div className="form-row">
        <ChoiceField label="Method" value={method} options={METHODS} onChoose={setMethod} />
        <ChoiceField label="Photographs per pixel" value={blended} options={BLENDED} onChoose={setBlended} />
      </div>
      <p className="dialog-note">
        Draws each photograph from all others, and compares the two. The report in the folder reports shows the images, and where their
        colors differ. A report of this capture is replaced.
      </p>
    </FormDialog>
  );
}

/** How well a capture shows its photographs, by method. */
export function RephotographedDialog({
  means: { path, views, means },
  onClose,
}: {
  readonly means: RephotographMeans;
  readonly onClose: () => void;
}) {
  const editor = useEditor();
  const show = () => showRephotographReport(editor, path, (url) => window.open(url, '_blank', 'noopener'));
  return (
    <Dialog
      title={`${nameOf(path)}, rephotographed`}
      onClose={onClose}
      actions={
        <>
          <Button look="quiet" onPress={onClose}>
            Close
          </Button>
          <Button look="primary" autoFocus icon="screen" onPress={() => void show()}>
            Open report
          </Button>
        </>
      }
    >
      <table className="rephotographed" aria-label="Means">
        <thead>
          <tr>
            <th scope="col">Method</th>
            <th scope="col" data-tip="Peak signal-to-noise ratio: higher is better">
              PSNR
            </th>
            <th scope="col" data-tip="Structural similarity: 1 is equal">
              SSIM
            </th>
            <th scope="col" data-tip="Mean of |ΔCb| + |ΔCr|, of 255">
              Color error
            </th>
          </tr>
        </thead>
        <tbody>
          {means.map(({ method, psnrDb, ssim, chromaError }) => (
            <tr key={method}>
              <th scope="row">{METHOD_WORDS[method]}</th>
              <td>{figure(psnrDb, 2, ' dB')}</td>
              <td>{figure(ssim, 3)}</td>
              <td>{figure(chromaError, 2)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p className="dialog-note">
        Means over {views} photographs, each drawn from all others, where the mesh covers it. The report has the figures and images of each.
      </p>
    </Dialog>
  );
}

function figure(value: number | null, digits: number, unit = ''): string {
  return value === null ? '–' : `${value.toFixed(digits)}${unit}`;
}
