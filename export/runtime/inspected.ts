import type { LayerRef } from '../program/program.ts';
import type { Engine } from './engine.ts';
import type { LiveResources } from './resources/resources.ts';

/** What an editor's tools look at after a frame: `readColor`, `readDepth`, `showLayer`, `probeDepth`. They stand beside the player, so that pages need not carry them. */
export interface Inspected {
  readonly engine: Engine;
  readonly resources: LiveResources;
  /** Null where no layer was asked for, or it is not tapped. */
  readonly layer: LayerRef | null;
}
