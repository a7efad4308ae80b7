import type { ModelDecoders } from './decoder.ts';
import { openDraco } from './draco.ts';
import { openKtx2 } from './ktx2.ts';
import { openMeshopt } from './meshopt.ts';

/** All decoders, for the editor; exported pages have those that their models need. */
export const ALL_DECODERS: Required<ModelDecoders> = { draco: openDraco, meshopt: openMeshopt, ktx2: openKtx2 };
