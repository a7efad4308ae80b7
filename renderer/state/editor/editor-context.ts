import { createContext, useContext, useRef } from 'react';
import { useStore } from 'zustand';
import type { ProjectLibrary } from '../../../export/graph/library/project-library.ts';
import type { DocumentState } from './document.ts';
import type { Editor } from './editor.ts';
import { hasSameTypes } from './library.ts';

const EditorContext = createContext<Editor | null>(null);

export const EditorProvider = EditorContext.Provider;

/** The editor of this page. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (!editor) throw new Error('useEditor must be called below EditorProvider.');
  return editor;
}

/** Selects a part of the document. The component rerenders only if that part changes. */
export function useDocument<T>(select: (state: DocumentState) => T): T {
  return useStore(useEditor().document, select);
}

/** The library, for its node types. The component does not render again if only the text of a shader changes. */
export function useNodeTypes(): ProjectLibrary {
  return useDocumentWhile((a, b) => hasSameTypes(a.library, b.library)).library;
}

/** The document at its last change according to `isSame`, for values that are expensive to compute from it. */
export function useDocumentWhile(isSame: (a: DocumentState, b: DocumentState) => boolean): DocumentState {
  const kept = useRef<DocumentState | null>(null);
  return useDocument((state) => {
    if (kept.current === null || !isSame(kept.current, state)) kept.current = state;
    return kept.current;
  });
}
