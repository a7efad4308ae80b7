import { type CapturedPlace, type PlaceParams, writeCapturedPlace } from '../../kit/captured-place.ts';
import type { NodeDefinition } from '../../kit/definition.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Writable } from '../../kit/value-views.ts';

/** What the operation has of the node Capture. */
export interface PlaceContext extends Omit<NodeContext<NodeDefinition>, 'assetIds' | 'params' | 'outputs'> {
  readonly assetIds: { readonly file: string | null };
  readonly params: PlaceParams;
  readonly outputs: { readonly capture: Writable<CapturedPlace> };
}

/**
 * Writes the output “Capture” of the node Capture. It is an operation of its own, because nodes that draw are updated after all others; so
 * readers have the place in the same frame, also if nothing shows the layer of the node.
 */
export function create({ assets, assetIds, params, outputs: { capture: place } }: PlaceContext): NodeRuntime {
  const id = assetIds.file;
  const handle = id === null ? null : assets.capture(id);
  place.assetId = id;
  return {
    get version() {
      const facts = handle?.value ?? null;
      return facts === null ? 0 : 1 + facts.version;
    },
    update: () => writeCapturedPlace(place, handle?.value ?? null, params),
    dispose: () => handle?.release(),
  };
}
