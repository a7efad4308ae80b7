import { type RefObject, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { own } from '../../export/graph/own.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useProblems } from '../shell/use-problems.ts';
import { chunkOf } from '../state/edit-header.ts';
import { besideOf, originalOf, projectFileOf, shaderOf, vertexOf } from '../state/edit-shader.ts';
import { takeBack } from '../state/outside.ts';
import { createTyping, type Typing } from '../state/typing.ts';
import { revealCode } from '../state/ui.ts';
import { CodeBar } from './code-bar.tsx';
import { CodeHead } from './code-head.tsx';
import { HeaderForm } from './header-form.tsx';
import type { ShaderEditor } from './monaco.ts';

const OUTSIDE = 'Another program has saved this. “Edit it here”, above, takes it back.';
const LIBRARY_CHUNK =
  'A chunk of the library is shared by all its techniques. “Copy chunk into project”, above, gives this project its own.';
const LIBRARY_VERTEX = 'A vertex shader of the library. “Copy into project”, above, copies it with its shader.';

interface Tools {
  readonly view: ShaderEditor;
  readonly typing: Typing;
}

/** The text of one node's shader with its problems marked; what is typed goes into the document at each pause. */
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
  /** A chunk or the vertex shader, looked at in the place of the node's own text. */
  const [looked, setLooked] = useState<{ readonly node: string; readonly file: string } | null>(null);
  const other = useDocument((state) => (looked?.node === node && state.library.shader(looked.file) !== undefined ? looked.file : null));
  const vertex = useDocument((state) => vertexOf(state, node));
  const chunk = other === vertex ? null : other;
  /** The node whose text stands beside its original. */
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
    // What is being typed is newer than the document.
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
      setLooked(position.file === null ? null : { node, file: position.file });
      return;
    }
    tools.view.goTo(position.line, position.column);
    editor.ui.setState({ codePosition: null });
  }, [editor, tools, position, node, other]);

  const hasForm = form && other === null;
  const onTakeBack = () => {
    const taken = other === null ? file : projectFileOf(other);
    if (taken !== null) takeBack(editor, taken);
    // The button goes with the bar that it is on: the focus has to have left it by then, or it is lost.
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
          setLooked(file === null ? null : { node, file });
        }}
        onForm={(headerForm) => editor.ui.setState({ headerForm })}
        onCompare={(on) => setCompared(on ? node : null)}
      />
      <CodeBar chunk={chunk} outside={readOnly === OUTSIDE} onTakeBack={onTakeBack} onBack={() => setLooked(null)} />
      {hasForm && <HeaderForm node={node} readOnly={readOnly !== null} />}
      {/* New browsers give Monaco text without a text field: the marks tell keys meant for the canvas, and React Flow, to keep off. */}
      <div ref={parent} className="code-text nokey" data-typing="" />
    </div>
  );
}

/** Why the text cannot be typed in: what `file` of the project, or another file in its place, is to others; null where it can. */
function useReadOnly(other: string | null, file: string | null): string | null {
  const editor = useEditor();
  const shown = other === null ? file : projectFileOf(other);
  const ofLibrary = useDocument(({ project }) => other !== null && shown !== null && own(project.sources, shown) === undefined);
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
    // Monaco is half of the editor's code, and most sessions begin without it.
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
        onRename: typing.along,
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
