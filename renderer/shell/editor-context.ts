import { createContext, useContext } from 'react';
import { useStore } from 'zustand';
import type { DocumentState } from '../state/document.ts';
import type { Editor } from '../state/editor.ts';

const EditorContext = createContext<Editor | null>(null);

export const EditorProvider = EditorContext.Provider;

/** The editor that this page shows. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (!editor) throw new Error('useEditor is only there below EditorProvider.');
  return editor;
}

/** A part of the document; the component is drawn anew when that part changes, and only then. */
export function useDocument<T>(select: (state: DocumentState) => T): T {
  return useStore(useEditor().document, select);
}
