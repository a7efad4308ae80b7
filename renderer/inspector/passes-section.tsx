import { useEffect, useState } from 'react';
import { type ExportedProgram, passesOf, startExportCompiler, watchExportedProgram } from '../state/compile/exported-passes.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerTitle, nodePath } from '../state/editor/layer-names.ts';
import { Button } from '../ui/button.tsx';

/** Tells which passes of the exported page draw a node, and why others are separate. The preview does not fuse passes. */
export function PassesSection({ id }: { readonly id: string }) {
  const [open, setOpen] = useState(false);
  return (
    <section className="inspector-section" aria-label="Passes">
      <Button pressed={open} onPress={() => setOpen(!open)}>
        Passes in the exported page
      </Button>
      {open && <Passes id={id} />}
    </section>
  );
}

function Passes({ id }: { readonly id: string }) {
  const editor = useEditor();
  const [exported, setExported] = useState<ExportedProgram | null>(null);
  useEffect(() => watchExportedProgram(editor, startExportCompiler(), setExported), [editor]);
  const lines = useDocument((state) =>
    exported === null ? '' : linesOf(exported, nodePath(state, id), (node) => layerTitle(state, `${node}.`)),
  );
  return (
    <output className="inspector-note">
      {exported === null ? 'Compiling…' : lines.split('\n').map((line) => <p key={line}>{line}</p>)}
    </output>
  );
}

/** Sentences, one per line. */
function linesOf(exported: ExportedProgram, node: string, titleOf: (node: string) => string): string {
  const { passes, inMaterialsOf, separate, folded } = passesOf(exported, node);
  if (folded !== null) {
    return `The page leaves the node out: ${folded.reason}${folded.instead === null ? '' : ` (${titleOf(folded.instead)})`}.`;
  }
  const drawn = passes.map((others) => {
    const names = [...new Set(others.map(titleOf))];
    return names.length === 0 ? 'A pass of its own.' : `One pass with ${names.join(', ')}.`;
  });
  const kept = separate.map(({ layer, reader, reason }) => {
    const writer = layer.slice(0, layer.indexOf('.', layer.lastIndexOf('/') + 1));
    return writer === reader
      ? `A texture between passes of ${titleOf(reader)}: ${reason}.`
      : `A texture between ${titleOf(writer)} and ${titleOf(reader)}: ${reason}.`;
  });
  if (inMaterialsOf.length > 0) return `Computed in the materials of ${inMaterialsOf.map(titleOf).join(', ')}, without a pass.`;
  return [
    ...new Set(passes.length === 0 ? ['No pass: the page leaves the node out, or draws it with objects.'] : [...drawn, ...kept]),
  ].join('\n');
}
