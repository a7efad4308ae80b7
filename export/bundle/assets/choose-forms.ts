import { gzipSync } from 'node:zlib';
import { measureModel } from '../../gltf/measure.ts';
import { readGltf } from '../../gltf/read-gltf.ts';
import type { CompressedModel } from '../compress/compressed-model.ts';
import { DECODER_BYTES, GPU_BYTES_PER_FILE_BYTE } from '../compress/compressed-model.ts';

export type Form = 'original' | 'meshopt' | 'ktx2';

export interface ModelForms {
  readonly original: Uint8Array;
  readonly compressed: CompressedModel;
}

export interface ChosenForm {
  readonly form: Form;
  readonly bytes: Uint8Array;
}

/**
 * Chooses the form of each model with the lowest total cost for visitors: bytes to download and graphics memory, including the required
 * decoders. A decoder is used only if it saves more over all models than it costs.
 */
export function chooseForms(models: readonly ModelForms[]): readonly ChosenForm[] {
  const priced = models.map(price);
  const choices = (['original', 'meshopt', 'ktx2'] as const).map((best) => {
    const chosen = priced.map((forms) => cheapest(forms, best));
    const cost = chosen.reduce((sum, form) => sum + form.cost, 0);
    const has = (form: Form) => chosen.some((c) => c.form === form);
    const decoders = (has('ktx2') ? DECODER_BYTES.ktx2 : 0) + (has('ktx2') || has('meshopt') ? DECODER_BYTES.meshopt : 0);
    return { chosen, cost: cost + decoders };
  });
  return choices.reduce((a, b) => (b.cost < a.cost ? b : a)).chosen;
}

interface PricedForm extends ChosenForm {
  readonly cost: number;
}

function price({ original, compressed }: ModelForms): readonly PricedForm[] {
  const forms: ChosenForm[] = [{ form: 'original', bytes: original }];
  if (compressed.meshopt) forms.push({ form: 'meshopt', bytes: compressed.meshopt });
  if (compressed.ktx2) forms.push({ form: 'ktx2', bytes: compressed.ktx2 });
  return forms.map((form) => ({ ...form, cost: downloadBytes(form.bytes) + gpuBytesOf(form.bytes) / GPU_BYTES_PER_FILE_BYTE }));
}

/** Mean of the sizes without and with gzip: some hosts compress models, others send them as they are. */
function downloadBytes(file: Uint8Array): number {
  return (file.length + gzipSync(file).length) / 2;
}

const ORDER: readonly Form[] = ['original', 'meshopt', 'ktx2'];

/** The cheapest form of a model among those that need no more decoders than `best` does. */
function cheapest(forms: readonly PricedForm[], best: Form): PricedForm {
  const allowed = forms.filter(({ form }) => ORDER.indexOf(form) <= ORDER.indexOf(best));
  return allowed.reduce((a, b) => (b.cost < a.cost ? b : a));
}

export function gpuBytesOf(model: Uint8Array): number {
  const { geometryBytes, textureBytes } = measureModel(readGltf(model));
  return geometryBytes + textureBytes;
}
