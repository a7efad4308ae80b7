import { type RefObject, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { getOwn } from '../../export/graph/record.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { chunkOf } from '../state/document/edit-header.ts';
import { besideOf, originalOf, projectFileOf, shaderOf, vertexOf } from '../state/document/edit-shader.ts';
import { createTyping, type Typing } from '../state/document/typing.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { revealCode } from '../state/editor/ui.ts';
import { editHere } from '../state/files/external-changes.ts';
import { useProblems } from '../state/problems/use-problems.ts';
import { CodeBar } from './code-bar.tsx';
import { CodeHead } from './code-head.tsx';
import { HeaderForm } from './header-form.tsx';
import type { ShaderEditor } from './monaco.ts';

const OUTSIDE = 'Read-only: another program saved this file. Press “Edit here” above to edit it.';
const LIBRARY_CHUNK = 'Read-only: materials of the library share this chunk. Press “Copy chunk into project” above to edit a copy.';
const LIBRARY_VERTEX = 'Read-only: this vertex shader is part of the library. Press “Copy into project” above to edit a copy.';

interface Tools {
  readonly view: ShaderEditor;
  readonly typing: Typing;
}

/** Shader text of a node, with problems marked. Edits go to the document after each pause in typing. */
export function ShaderView({ node }: { readonly node: string }) {
  const editor = useEditor();
  const handle = useDocument((state) => state.open?.handle ?? '');
  const name = useDocument((state) => shaderOf(state, node)?.name ?? '');
  const text = useDocument((state) => shaderOf(state, node)?.text ?? '');
  const original = useDocument((state) => originalOf(editor, state, node)?.text ?? null);
  const problems = useProblems();
  const position = useStore(editor.ui, (state) => state.codePosition);
  const file = useDocument((state) => shaderOf(state, node)?.file ?? null);
  const form = useStore(editor.ui, (state) => state.headerForm);
  /** File shown instead of the shader of the node: a chunk or the vertex shader. */
  const [override, setOverride] = useState<{ readonly node: string; readonly file: string } | null>(null);
  const other = useDocument((state) =>
    override?.node === node && state.library.shader(override.file) !== undefined ? override.file : null,
  );
  const vertex = useDocument((state) => vertexOf(state, node));
  const chunk = other === vertex ? null : other;
  /** Node whose shader is compared with its original. */
  const [compared, setCompared] = useState<string | null>(null);
  const comparing = compared === node && other === null;
  const parent = useRef<HTMLDivElement>(null);
  const tools = useShaderEditor(parent);
  const shown = other ?? node;
  const shownFile = other ?? name;
  const shownText = useDocument((state) => (other === null ? text : (state.library.shader(other) ?? '')));
  const readOnly = useReadOnly(other, file);

  useEffect(() => {
    if (!tools) return;
    tools.typing.flush(shown);
    // Text being typed is newer than the document.
    if (!tools.typing.isAhead(shown)) tools.view.show({ name: `${handle}/${shown}`, file: shownFile, text: shownText, readOnly });
  }, [tools, handle, shown, shownFile, shownText, readOnly]);

  const scale = useStore(editor.preferences, (state) => state.scale);
  useEffect(() => tools?.view.setScale(scale), [tools, scale]);

  useEffect(() => tools?.view.forget((kept) => kept.startsWith(`${handle}/`)), [tools, handle]);

  useEffect(() => tools?.view.compare(comparing ? original : null), [tools, comparing, original]);

  useEffect(() => {
    tools?.view.mark(problems.filter((problem) => (other === null ? isAbout(problem, node, name) : problem.file === other)));
  }, [tools, problems, node, name, other]);

  useEffect(() => {
    if (position === null || !tools) return;
    if (position.file !== other) {
      setOverride(position.file === null ? null : { node, file: position.file });
      return;
    }
    tools.view.goTo(position.line, position.column);
    editor.ui.setState({ codePosition: null });
  }, [editor, tools, position, node, other]);

  const hasForm = form && other === null;
  const onTakeBack = () => {
    const taken = other === null ? file : projectFileOf(other);
    if (taken !== null) editHere(editor, taken);
    // The bar with the focused button disappears, so the focus moves on first.
    tools?.view.focus();
  };

  return (
    <div className={hasForm ? 'shader-view shader-view-with-form' : 'shader-view'}>
      <CodeHead
        node={node}
        form={form}
        comparing={comparing}
        readOnly={readOnly !== null}
        inVertex={vertex !== null && other === vertex}
        onVertex={(on) => {
          const file = on ? vertexOf(editor.document.getState(), node) : null;
          setOverride(file === null ? null : { node, file });
        }}
        onForm={(headerForm) => editor.ui.setState({ headerForm })}
        onCompare={(on) => setCompared(on ? node : null)}
      />
      <CodeBar chunk={chunk} outside={readOnly === OUTSIDE} onTakeBack={onTakeBack} onBack={() => setOverride(null)} />
      {hasForm && <HeaderForm node={node} readOnly={readOnly !== null} />}
      {/* Monaco uses EditContext instead of a text field in new browsers: the class and attribute mark it as text input for shortcuts and React Flow. */}
      <div ref={parent} className="code-text nokey" data-typing="" />
    </div>
  );
}

/** Why the shown text is read-only: `other` if it is shown instead of the project file `file`; null if it is editable. */
function useReadOnly(other: string | null, file: string | null): string | null {
  const editor = useEditor();
  const shown = other === null ? file : projectFileOf(other);
  const ofLibrary = useDocument(({ project }) => other !== null && shown !== null && getOwn(project.sources, shown) === undefined);
  const outside = useStore(editor.ui, (state) => state.outside.includes(shown ?? ''));
  if (ofLibrary) return other?.endsWith('.vs') ? LIBRARY_VERTEX : LIBRARY_CHUNK;
  return outside ? OUTSIDE : null;
}

function useShaderEditor(parent: RefObject<HTMLDivElement | null>): Tools | null {
  const editor = useEditor();
  const [tools, setTools] = useState<Tools | null>(null);
  useEffect(() => {
    const element = parent.current;
    if (!element) return;
    const typing = createTyping(editor);
    let view: ShaderEditor | null = null;
    let stopped = false;
    // Monaco is half of the bundle, and most sessions start without it.
    void import('./monaco.ts').then(({ createShaderEditor }) => {
      if (stopped) return;
      view = createShaderEditor(element, {
        texts: { chunkOf: chunkOf(editor), besideOf: (file) => besideOf(editor.document.getState(), file) },
        onType: (key, text, live) => {
          const shader = key.slice(key.indexOf('/') + 1);
          if (live) typing.tune(shader, text);
          else typing.type(shader, text);
        },
        onLeave: typing.end,
        onRename: typing.pairWith,
        onOther: (file, line, column) => revealCode(editor.ui, line, column, file.endsWith('.fs') ? null : file),
      });
      setTools({ view, typing });
    });
    return () => {
      stopped = true;
      typing.dispose();
      view?.dispose();
      setTools(null);
    };
  }, [editor, parent]);
  return tools;
}

function isAbout({ nodeId, file, line }: Diagnostic, node: string, name: string): boolean {
  return line !== undefined && (file === name || (file === undefined && nodeId === node));
}
