import { type RefObject, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useProblems } from '../shell/use-problems.ts';
import { chunkOf } from '../state/edit-header.ts';
import { originalOf, shaderOf } from '../state/edit-shader.ts';
import { takeBack } from '../state/outside.ts';
import { createTyping, type Typing } from '../state/typing.ts';
import { Button } from '../ui/button.tsx';
import { Icon } from '../ui/icon.tsx';
import { CodeHead } from './code-head.tsx';
import { HeaderForm } from './header-form.tsx';
import type { ShaderEditor } from './monaco.ts';

const OUTSIDE = 'Another program has saved this shader. “Edit it here”, above, takes it back.';

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
  const outside = useStore(editor.ui, (state) => file !== null && state.outside.includes(file));
  const form = useStore(editor.ui, (state) => state.headerForm);
  const [chunk, setChunk] = useState<string | null>(null);
  /** The node whose text stands beside its original. */
  const [compared, setCompared] = useState<string | null>(null);
  const comparing = compared === node;
  const parent = useRef<HTMLDivElement>(null);
  const tools = useShaderEditor(parent, setChunk);

  useEffect(() => {
    if (!tools) return;
    tools.typing.flush(node);
    // What is being typed is newer than the document.
    if (!tools.typing.isAhead(node)) tools.view.show({ name: `${handle}/${node}`, file: name, text, readOnly: outside ? OUTSIDE : null });
  }, [tools, handle, node, name, text, outside]);

  useEffect(() => tools?.view.forget((kept) => kept.startsWith(`${handle}/`)), [tools, handle]);

  useEffect(() => tools?.view.compare(comparing ? original : null), [tools, comparing, original]);

  useEffect(() => {
    tools?.view.mark(problems.filter((problem) => isAbout(problem, node, name)));
  }, [tools, problems, node, name]);

  useEffect(() => {
    if (position === null || !tools) return;
    tools.view.goTo(position.line, position.column);
    editor.ui.setState({ codePosition: null });
  }, [editor, tools, position]);

  const onTakeBack = () => {
    if (file !== null) takeBack(editor, file);
    // The button goes with the bar that it is on: the focus has to have left it by then, or it is lost.
    tools?.view.focus();
  };

  return (
    <div className={form ? 'shader-view shader-view-with-form' : 'shader-view'}>
      <CodeHead
        node={node}
        form={form}
        comparing={comparing}
        readOnly={outside}
        onForm={(headerForm) => editor.ui.setState({ headerForm })}
        onCompare={(on) => setCompared(on ? node : null)}
      />
      {chunk !== null && (
        <p className="code-bar">
          <code>{chunk}</code>
          <span>A chunk of the library, to be read.</span>
          <Button look="quiet" onPress={() => tools?.view.showChunk(null)}>
            Back to the shader
          </Button>
        </p>
      )}
      {chunk === null && outside && (
        <p className="code-bar code-bar-outside">
          <Icon name="link" size={14} />
          <span>Another program has saved this shader: it is read only here, and follows what is saved there.</span>
          <Button look="quiet" onPress={onTakeBack}>
            Edit it here
          </Button>
        </p>
      )}
      {form && <HeaderForm node={node} readOnly={outside} />}
      {/* New browsers give Monaco text without a text field: the marks tell keys meant for the canvas, and React Flow, to keep off. */}
      <div ref={parent} className="code-text nokey" data-typing="" />
    </div>
  );
}

function useShaderEditor(parent: RefObject<HTMLDivElement | null>, onChunk: (file: string | null) => void): Tools | null {
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
        chunkOf: chunkOf(editor),
        onType: (key, text, live) => {
          const node = key.slice(key.indexOf('/') + 1);
          if (live) typing.tune(node, text);
          else typing.type(node, text);
        },
        onLeave: typing.end,
        onChunk,
      });
      setTools({ view, typing });
    });
    return () => {
      stopped = true;
      typing.dispose();
      view?.dispose();
      setTools(null);
    };
  }, [editor, parent, onChunk]);
  return tools;
}

function isAbout({ nodeId, file, line }: Diagnostic, node: string, name: string): boolean {
  return line !== undefined && (file === name || (file === undefined && nodeId === node));
}
