import { useMemo } from 'react';
import { useStore } from 'zustand';
import { getOwn } from '../../export/graph/record.ts';
import type { PhotographsRequest } from '../preview-protocol.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';

export interface PhotographedLayer {
  /** Null until the program with the layer is compiled, and if it cannot be photographed. */
  readonly request: PhotographsRequest | null;
  /** Why the layer cannot be photographed. */
  readonly error: string | null;
}

/** What a page needs to photograph a layer. */
export function usePhotographedLayer(layer: string): PhotographedLayer {
  const editor = useEditor();
  const revision = useDocument((state) => state.revision);
  const assetBaseUrl = useDocument((state) => state.open?.assetBaseUrl ?? null);
  const program = useStore(editor.compile, (state) => state.program);
  const programRevision = useStore(editor.compile, (state) => state.programRevision);
  const busy = useStore(editor.compile, (state) => state.busy);
  const values = useStore(editor.compile, (state) => state.laterValues);
  return useMemo(() => {
    const nothing = (error: string | null) => ({ request: null, error });
    if (layer === '') return nothing('This project has no layer. Add a Scene and connect it to the Output.');
    if (program === null || assetBaseUrl === null || (programRevision !== revision && !busy)) {
      return nothing(busy ? null : 'The project has problems. Fix them first.');
    }
    const found = getOwn(program.taps, layer);
    // The program of the layer before, while the next one is compiled.
    if (found === undefined) return nothing(busy ? null : 'Connect the inputs of this node first.');
    if (found.depth === null) return nothing('This layer has no depth. Choose that of a Scene.');
    return { request: { program, values, assetBaseUrl, layer }, error: null };
  }, [layer, program, programRevision, revision, busy, values, assetBaseUrl]);
}
