import { type RefObject, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useProblems } from '../shell/use-problems.ts';
import { titleOf } from '../state/document.ts';
import { shaderOf } from '../state/edit-shader.ts';
import { createTyping, type Typing } from '../state/typing.ts';
import type { ShaderEditor } from './monaco.ts';

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
  const problems = useProblems();
  const position = useStore(editor.ui, (state) => state.codePosition);
  const parent = useRef<HTMLDivElement>(null);
  const tools = useShaderEditor(parent);

  useEffect(() => {
    if (!tools) return;
    tools.typing.flush(node);
    // What is being typed is newer than the document.
    if (!tools.typing.isAhead(node)) tools.view.show(`${handle}/${node}`, text);
  }, [tools, handle, node, text]);

  useEffect(() => tools?.view.forget((kept) => kept.startsWith(`${handle}/`)), [tools, handle]);

  useEffect(() => {
    tools?.view.mark(problems.filter((problem) => isAbout(problem, node, name)));
  }, [tools, problems, node, name]);

  useEffect(() => {
    if (position === null || !tools) return;
    tools.view.goTo(position.line, position.column);
    editor.ui.setState({ codePosition: null });
  }, [editor, tools, position]);

  return (
    <div className="code">
      <CodeHead node={node} name={name} />
      {/* New browsers give Monaco text without a text field: the marks tell keys meant for the canvas, and React Flow, to keep off. */}
      <div ref={parent} className="code-text nokey" data-typing="" />
    </div>
  );
}

function CodeHead({ node, name }: { readonly node: string; readonly name: string }) {
  const title = useDocument((state) => titleOf(state, node));
  const ofLibrary = !name.startsWith('shaders/');
  return (
    <p className="code-head">
      <strong>{title}</strong>
      <code>{name}</code>
      {ofLibrary && <span>From the library: the first change makes a copy in this project.</span>}
    </p>
  );
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
        onType: (key, text) => typing.type(key.slice(key.indexOf('/') + 1), text),
        onLeave: typing.end,
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
