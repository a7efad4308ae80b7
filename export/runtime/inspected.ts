import type { LayerRef, Program } from '../program/program.ts';
import type { Engine } from './engine.ts';
import type { LiveResources } from './resources/resources.ts';
import type { Slots } from './values/slots.ts';

/** What an editor's tools look at after a frame: `readColor`, `readDepth`, `showLayer`, `probeDepth`, `placedObjects`, `pickObject`. They stand beside the player, so that pages need not carry them. */
export interface Inspected {
  readonly engine: Engine;
  readonly program: Program;
  readonly slots: Slots;
  readonly resources: LiveResources;
  /** Null where no layer was asked for, or it is not tapped. */
  readonly layer: LayerRef | null;
}
