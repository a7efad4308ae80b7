import type { LayerRef, Program } from '../program/program.ts';
import type { Engine } from './engine.ts';
import type { LiveResources } from './resources/resources.ts';
import type { Slots } from './values/slots.ts';

/**
 * What tools of the editor need to read the last frame: `readColor`, `readDepth`, `showLayer`, `probeDepth`, `placedObjects`, `pickObject`,
 * `createPosterCamera`. They are separate functions, so that pages do not bundle them.
 */
export interface Inspected {
  readonly engine: Engine;
  readonly program: Program;
  readonly slots: Slots;
  readonly resources: LiveResources;
  /** The requested layer; null if none was requested or it is not viewed. */
  readonly layer: LayerRef | null;
}
