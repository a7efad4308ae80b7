import { useEffect, useMemo, useState } from 'react';
import { MAIN_GRAPH } from '../../export/graph/project.ts';
import {
  type AcquisitionForm,
  type AcquisitionPlan,
  captureFileBytes,
  defaultForm,
  hasYaw,
  photographsGpuBytes,
  readForm,
  withProjection,
} from '../state/acquisition/acquisition-form.ts';
import { photographScene } from '../state/acquisition/photograph-scene.ts';
import type { DocumentState } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerTitle } from '../state/editor/layer-names.ts';
import { byteText } from '../state/files/byte-text.ts';
import { screenLayer } from '../state/preview/viewed-layers.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import { ChoiceField, FieldGroup, TextField } from '../ui/form-fields.tsx';
import type { SelectOption } from '../ui/select-field.tsx';
import { PhotographPreview } from './photograph-preview.tsx';
import { usePhotographedLayer } from './photographed-layer.ts';
import './photograph-dialog.css';

const SHAPES: readonly SelectOption<AcquisitionForm['shape']>[] = [
  { value: 'outside-in', label: 'Sphere, looking in' },
  { value: 'inside-out', label: 'Sphere, looking out' },
  { value: 'grid', label: 'Grid' },
];
const PROJECTIONS: readonly SelectOption<AcquisitionForm['projection']>[] = [
  { value: 'perspective', label: 'Perspective' },
  { value: 'equirectangular', label: '360°' },
];
const AXES = ['x', 'y', 'z'];

/** Where the cameras of an acquisition stand, and what they see. */
export function PhotographDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const state = useDocument((whole) => whole);
  const layers = useMemo(() => layersOf(state), [state]);
  const [form, setForm] = useState(() => defaultForm(editor.document.getState().project.title));
  const [layer, setLayer] = useState(() => screenLayer(editor.document.getState()) ?? layers[0] ?? '');
  const set = (part: Partial<AcquisitionForm>) => setForm((before) => ({ ...before, ...part }));
  const { plan, errors } = useMemo(() => readForm(form), [form]);
  const photographed = usePhotographedLayer(layer);
  /** Size of the previewed photograph as PNG file, per pixel. */
  const [pngBytes, setPngBytes] = useState<number | null>(null);
  const isGrid = form.shape === 'grid';
  const isAround = form.projection === 'equirectangular';
  useEffect(() => {
    editor.viewer.setState({ photographed: layer === '' ? null : layer });
  }, [editor, layer]);
  useEffect(() => () => editor.viewer.setState({ photographed: null }), [editor]);
  return (
    <FormDialog
      title="Photograph the scene"
      action="Take photographs"
      ready={plan !== null && photographed.request !== null}
      onGo={() => void (plan && photographScene(editor, plan, layer))}
      onClose={onClose}
      size="large"
    >
      <div className="photograph-columns">
        <div className="dialog-form">
          <TextField label="Name of the capture" text={form.name} error={errors.name} plain onChange={(name) => set({ name })} />
          <ChoiceField
            label="Layer"
            value={layer}
            options={layers.map((value) => ({ value, label: layerTitle(state, value) }))}
            error={photographed.error ?? undefined}
            onChoose={setLayer}
          />
          <div className="form-row">
            <ChoiceField label="Cameras" value={form.shape} options={SHAPES} onChoose={(shape) => set({ shape })} />
            {isGrid ? (
              <FieldGroup
                legend="Number along"
                names={AXES}
                texts={form.counts}
                error={errors.counts}
                onChange={(counts) => set({ counts: asThree(counts) })}
              />
            ) : (
              <TextField label="Number" text={form.count} error={errors.count} onChange={(count) => set({ count })} />
            )}
          </div>
          <FieldGroup
            legend="Center (m)"
            names={AXES}
            texts={form.center}
            error={errors.center}
            onChange={(center) => set({ center: asThree(center) })}
          />
          <FieldGroup
            legend={isGrid ? 'Size (m)' : 'Diameters (m)'}
            names={AXES}
            texts={form.extent}
            error={errors.extent}
            onChange={(extent) => set({ extent: asThree(extent) })}
          />
          <div className="form-row">
            {!isGrid && (
              <FieldGroup
                legend="Heights above the center (°)"
                names={['from', 'to']}
                texts={[form.lowest, form.highest]}
                error={errors.elevation}
                onChange={([lowest = '', highest = '']) => set({ lowest, highest })}
              />
            )}
            {hasYaw(form) && <TextField label="Turned left (°)" text={form.yaw} error={errors.yaw} onChange={(yaw) => set({ yaw })} />}
          </div>
          <div className="form-row">
            <ChoiceField
              label="Projection"
              value={form.projection}
              options={PROJECTIONS}
              onChoose={(projection) => setForm(withProjection(form, projection))}
            />
            {!isAround && <TextField label="Field of view (°)" text={form.fov} error={errors.fov} onChange={(fov) => set({ fov })} />}
          </div>
          {isAround ? (
            <TextField label="Width (pixels)" text={form.width} error={errors.size} onChange={(width) => set({ width })} />
          ) : (
            <FieldGroup
              legend="Size (pixels)"
              names={['width', 'height']}
              texts={[form.width, form.height]}
              error={errors.size}
              onChange={([width = '', height = '']) => set({ width, height })}
            />
          )}
        </div>
        <div className="photograph-side">
          <PhotographPreview plan={plan} request={photographed.request} onPngBytes={setPngBytes} />
          <p className="dialog-note" role="status">
            {plan === null ? 'A field has an error. ' : summary(plan, pngBytes)}
            Photographs show the scene at time 0, without the image of a camera.
          </p>
        </div>
      </div>
    </FormDialog>
  );
}

function asThree([x = '', y = '', z = '']: readonly string[]): readonly [string, string, string] {
  return [x, y, z];
}

/** All layers of the main graph, as `node.port`. */
function layersOf({ project, library }: DocumentState): readonly string[] {
  const nodes = Object.entries(project.graphs[MAIN_GRAPH]?.nodes ?? {});
  return nodes.flatMap(([id, { type }]) =>
    Object.entries(library.definition(type)?.outputs ?? {}).flatMap(([port, output]) => (output.type === 'layer' ? [`${id}.${port}`] : [])),
  );
}

function summary(plan: AcquisitionPlan, pngBytesPerPx: number | null): string {
  const count = plan.poses.length;
  const files = pngBytesPerPx === null ? '' : `about ${byteText(captureFileBytes(plan, pngBytesPerPx))} on disk, `;
  return `${count === 1 ? '1 photograph' : `${count} photographs`}: ${files}${byteText(photographsGpuBytes(plan))} on the GPU. `;
}
