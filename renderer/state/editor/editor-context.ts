import { createContext, useContext, useRef } from 'react';
import { useStore } from 'zustand';
import type { DocumentState } from './document.ts';
import type { Editor } from './editor.ts';

const EditorContext = createContext<Editor | null>(null);

export const EditorProvider = EditorContext.Provider;

/** The editor that this page shows. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (!editor) throw new Error('useEditor is only there below EditorProvider.');
  return editor;
}

/** A part of the document; the component renders again only when that part changes. */
export function useDocument<T>(select: (state: DocumentState) => T): T {
  return useStore(useEditor().document, select);
}

/** The document as it was when `isSame` last found it another: for what takes long to work out of it. */
export function useDocumentWhile(isSame: (a: DocumentState, b: DocumentState) => boolean): DocumentState {
  const kept = useRef<DocumentState | null>(null);
  return useDocument((state) => {
    if (kept.current === null || !isSame(kept.current, state)) kept.current = state;
    return kept.current;
  });
}
